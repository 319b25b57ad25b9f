// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "apps/command.h"
#include "apps/picture_size.h"
#include "apps/signals.h"
#include "core/files.h"
#include "core/log.h"
#include "core/text.h"
#include "detection/box_file.h"
#include "detection/class_names.h"
#include "detection/network.h"
#include "detection/yolo_detector.h"
#include "pictures/endings.h"
#include "pictures/picture_file.h"
#include "runs/draw_boxes.h"
#include "runs/judge_detector.h"
#include "runs/picture_source.h"
#include "runs/signed_picture.h"
#include "runs/unreadable.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

struct DetectArguments {
  std::vector<std::string> places;
  std::string model, evaluate, set, engine = "auto";
  std::optional<std::string> confidence, most_overlap, classes, save, size;
  bool wants_json = false;
};

Result<double> ReadShare(const std::optional<std::string>& text, const char* option, double otherwise) {
  if (!text) return otherwise;
  const auto value = ParseDouble(Trim(*text));
  if (!value || !(*value >= 0.001 && *value <= 1))
    return BadInput(std::string(option) + " " + *text + " must be a number from 0.001 to 1");
  return *value;
}

Result<DetectionOptions> OptionsOf(const DetectArguments& arguments) {
  // Evaluations want to see the whole curve, down to the weakest boxes, and doubles judged as the literature does.
  constexpr double kLeastConfidence = 0.001, kEvaluationOverlap = 0.6;
  DetectionOptions options;
  options.model = arguments.model;
  options.engine = arguments.engine;
  const bool is_evaluation = !arguments.evaluate.empty();
  const auto confidence = ReadShare(arguments.confidence, "--conf", options.confidence);
  if (!confidence) return confidence.error();
  const auto most_overlap =
      ReadShare(arguments.most_overlap, "--iou", is_evaluation ? kEvaluationOverlap : options.most_overlap);
  if (!most_overlap) return most_overlap.error();
  if (arguments.size && arguments.size->find('x') != std::string::npos) {
    const auto size = ReadPictureSize(arguments.size);
    if (!size) return size.error();
    options.width = size->width, options.height = size->height;
  }
  options.confidence = is_evaluation ? kLeastConfidence : *confidence;
  options.most_overlap = *most_overlap;
  return options;
}

/// The sides that --size N,N,... names; none where it is left out.
Result<std::vector<int>> LongSidesOf(const DetectArguments& arguments) {
  std::vector<int> sides;
  if (!arguments.size) return sides;
  for (const std::string_view word : SplitAt(*arguments.size, ',')) {
    const long long side = ParseInteger(Trim(word)).value_or(0);
    if (side < kCellSize || side > kLargestSize)
      return BadInput("--size " + *arguments.size + " must be the longer side of pictures, " +
                      std::to_string(kCellSize) + " to " + std::to_string(kLargestSize) +
                      ", or WIDTHxHEIGHT, such as 416 or 320x256, or several longer sides, such as 320,512,832");
    sides.push_back(static_cast<int>(side));
  }
  if (sides.size() > kMostLooks)
    return BadInput("--size " + *arguments.size + " names more than " + std::to_string(kMostLooks) + " looks");
  return sides;
}

/// The network, ready for pictures in their own shape where it can, or of the one size that --size WxH names.
Result<std::unique_ptr<YoloDetector>> OpenDetector(const DetectArguments& arguments, const DetectionOptions& options) {
  if (options.width > 0) return YoloDetector::Open(options);
  const auto sides = LongSidesOf(arguments);
  if (!sides) return sides.error();
  auto detector = YoloDetector::Open(options);
  if (!detector) return detector;
  if (const Status fitted = (*detector)->FitToPictures(*sides); !fitted) return fitted.error();
  return detector;
}

/// The classes of --classes, by their names or their places in the list of the known; bad input for one that is not
/// among them. A comma too many is no class.
Result<std::vector<std::string>> ClassesOf(const DetectArguments& arguments, const std::vector<std::string>& known) {
  std::vector<std::string> classes;
  if (!arguments.classes) return classes;
  for (const std::string_view part : SplitAt(*arguments.classes, ',')) {
    std::string word(Trim(part));
    if (word.empty()) continue;
    const auto is_same = [&](const std::string& name) { return FoldClassName(name) == FoldClassName(word); };
    if (std::none_of(known.begin(), known.end(), is_same)) {
      const auto place = ParseInteger(word);
      if (!place || *place < 0 || *place >= static_cast<long long>(known.size())) {
        return BadInput("--classes: '" + word + "' is no class that is known here; did you mean " +
                        NearestWord(word, known) + "?");
      }
      word = known[static_cast<size_t>(*place)];
    }
    classes.push_back(std::move(word));
  }
  if (classes.empty()) return BadInput("--classes " + *arguments.classes + " names no class; such as person,dog");
  return classes;
}

/// Everything that is done with the boxes of one picture.
class BoxOutput {
 public:
  BoxOutput(const DetectArguments& arguments, std::vector<std::string> classes)
      : wants_json_(arguments.wants_json), save_(arguments.save), classes_(std::move(classes)) {}

  Status Give(const SourcePicture& picture, std::vector<Box> boxes) {
    boxes.erase(std::remove_if(boxes.begin(), boxes.end(), [&](const Box& box) { return !IsWanted(box); }),
                boxes.end());
    std::fputs((wants_json_ ? JsonOf(picture, boxes) : TextOf(picture, boxes)).c_str(), stdout);
    return save_ ? Save(picture, boxes) : Status::Ok();
  }

 private:
  bool IsWanted(const Box& box) const {
    const auto is_same = [&](const std::string& name) { return FoldClassName(name) == FoldClassName(box.name); };
    return classes_.empty() || std::any_of(classes_.begin(), classes_.end(), is_same);
  }

  static std::string JsonOf(const SourcePicture& picture, const std::vector<Box>& boxes) {
    return ToJsonLine({picture.time, picture.image, picture.pixels.cols, picture.pixels.rows}, boxes) + "\n";
  }

  static std::string TextOf(const SourcePicture& picture, const std::vector<Box>& boxes) {
    std::string text = picture.image + (picture.time ? " " + ToString(*picture.time) : "") + " " +
                       std::to_string(picture.pixels.cols) + "x" + std::to_string(picture.pixels.rows) +
                       (boxes.empty() ? ": nothing\n" : ":\n");
    for (const Box& box : boxes) {
      text += "  " + box.name + " " + FormatFixed(box.confidence, 2) + "  left " + FormatFixed(box.left, 1) + " top " +
              FormatFixed(box.top, 1) + " right " + FormatFixed(box.right, 1) + " bottom " +
              FormatFixed(box.bottom, 1) + "\n";
    }
    return text;
  }

  /// What a picture with boxes is made of: an earlier run's picture of the same is replaced.
  static std::string SourceOf(const SourcePicture& picture) {
    std::error_code ignored;
    return fs::weakly_canonical(picture.image, ignored).string() + '\n' + picture.name;
  }

  /// Whether something is there that is not ours: a picture of somebody's, or one that was made of another.
  static bool IsTaken(const std::string& path, const std::string& source) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) return false;
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream content;
    content << stream.rdbuf();
    return !IsSignedPicture(content.str(), source);
  }

  std::string FreePath(const std::string& path, const std::string& source) {
    bool was_there = false;
    const std::string free = UntakenPath(path, [&](const std::string& candidate) {
      if (written_.count(candidate) > 0) return true;
      const bool is_taken = IsTaken(candidate, source);
      was_there |= is_taken;
      return is_taken;
    });
    written_.insert(free);
    if (was_there) LogWarning("picture-there", path + " was there before and stays; the boxes are in " + free);
    return free;
  }

  /// Under the picture's own name, numbered where another source has one of that name.
  Status Save(const SourcePicture& picture, const std::vector<Box>& boxes) {
    fs::path name = picture.name;
    if (!HasJpegEnding(picture.name)) name.replace_extension(".png");
    const std::string source = SourceOf(picture), path = FreePath((fs::path(*save_) / name).string(), source);
    const auto bytes = EncodePictureFor(path, DrawBoxes(picture.pixels, boxes));
    return bytes ? WriteFileWhole(path, SignedPicture(*bytes, source)) : Status(bytes.error());
  }

  bool wants_json_;
  std::optional<std::string> save_;
  std::vector<std::string> classes_;
  std::set<std::string> written_;
};

Status DetectIn(PictureSource& source, YoloDetector& detector, BoxOutput& output, Unreadable& unreadable) {
  while (source.HasNext() && !IsStopAsked()) {
    const auto picture = source.Next();
    if (!picture) {
      unreadable.Add(picture.error());
      continue;
    }
    auto detections = detector.Detect(ImageSetOf(picture->pixels));
    if (!detections) return detections.error();
    if (Status given = output.Give(*picture, std::move(detections->boxes)); !given) return given;
  }
  return Status::Ok();
}

Status CheckFolderIsWritable(const std::string& folder) {
  const std::string probe = (fs::path(folder) / ".yorb_probe").string();
  if (const Status written = WriteFileWhole(probe, ""); !written) return BadInput("--save: " + written.error().message);
  std::error_code ignored;
  fs::remove(probe, ignored);
  return Status::Ok();
}

/// Pictures are saved under their own names: among themselves they would be overwritten.
Status CheckPicturesStay(const DetectArguments& arguments) {
  std::error_code ignored;
  for (const fs::path place : arguments.places) {
    const fs::path folder = fs::is_directory(place, ignored) ? place : fs::absolute(place, ignored).parent_path();
    if (fs::equivalent(folder, *arguments.save, ignored))
      return BadInput("--save: " + *arguments.save + " is where the pictures are; name another folder");
  }
  return Status::Ok();
}

Status DetectAll(const DetectArguments& arguments, const DetectionOptions& options) {
  if (arguments.places.empty())
    return BadInput("yorb detect needs a picture, folder, video or sequence, or --evaluate DIR");
  auto detector = OpenDetector(arguments, options);
  if (!detector) return detector.error();
  auto classes = ClassesOf(arguments, (*detector)->names());
  if (!classes) return classes.error();
  if (arguments.save) {
    if (Status stays = CheckPicturesStay(arguments); !stays) return stays;
    if (Status writable = CheckFolderIsWritable(*arguments.save); !writable) return writable;
  }
  BoxOutput output(arguments, *std::move(classes));
  Unreadable unreadable;
  for (const std::string& place : arguments.places) {
    const auto source = OpenPictureSource(place);
    if (!source) {
      unreadable.Add(source.error());
      continue;
    }
    if (Status status = DetectIn(**source, **detector, output, unreadable); !status) return status;
  }
  return unreadable.Told();
}

Status EvaluateDetector(const DetectArguments& arguments, const DetectionOptions& options) {
  if (!arguments.places.empty())
    return BadInput("--evaluate DIR takes no further pictures: " + arguments.places.front());
  if (arguments.save) return BadInput("--save goes with pictures, not with --evaluate");
  const auto confidence = ReadShare(arguments.confidence, "--conf", DetectionOptions().confidence);
  if (!confidence) return confidence.error();
  auto detector = OpenDetector(arguments, options);
  if (!detector) return detector.error();
  const auto set = ReadLabelledSet(arguments.evaluate, arguments.set);
  if (!set) return set.error();
  const auto classes = ClassesOf(arguments, set->classes);
  if (!classes) return classes.error();
  (*detector)->TakeAllClasses();
  const auto judgement = JudgeDetector(*set, **detector, {*confidence, *classes, IsStopAsked});
  if (!judgement) return judgement.error();
  std::fputs((arguments.wants_json ? JudgementJson(*judgement) : JudgementText(*judgement)).c_str(), stdout);
  return judgement->unreadable.Told();
}

int Detect(const DetectArguments& arguments) {
  CatchSignals();
  const Status started = StartLog({.to_stdout = !arguments.wants_json});
  if (!started) return Complain(started.error());
  const auto options = OptionsOf(arguments);
  const Status done = !options                     ? Status(options.error())
                      : arguments.evaluate.empty() ? DetectAll(arguments, *options)
                                                   : EvaluateDetector(arguments, *options);
  const Status stopped = StopLog();
  if (!done) return Complain(done.error());
  if (!stopped) return Complain(stopped.error());
  return ExitCodeAfterSignal(kExitDone);
}

}  // namespace

void AddDetectCommand(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("detect", "Finds people and things in pictures, or measures a detector");
  const auto a = std::make_shared<DetectArguments>();
  command->add_option("PLACES", a->places, "Pictures, folders, videos or sequences in TUM layout")
      ->type_name("PICTURE|FOLDER|VIDEO|SEQUENCE");
  command->add_option("--model", a->model, "Any YOLO network as ONNX [models/yolo_mo.onnx]")->type_name("FILE");
  command
      ->add_option(
          "--size", a->size,
          "What the network looks at: N, the longer side in px, the other as the picture has it; several for as many "
          "looks, each slower and all together surer; or WxH for all [as the network's file says]")
      ->type_name("N|N,N,..|WxH");
  command->add_option("--conf", a->confidence, "Boxes below this confidence are left out [.25]")->type_name("X");
  command
      ->add_option("--iou", a->most_overlap, "Boxes of one class that overlap more are doubles [.45; --evaluate: .6]")
      ->type_name("X");
  command->add_option("--classes", a->classes, "Only these, by name or by number in the network's list")
      ->type_name("A,B");
  command->add_flag("--json", a->wants_json, "A JSON line a picture; with --evaluate one JSON document");
  command->add_option("--save", a->save, "Pictures with the boxes drawn in go into this folder")->type_name("DIR");
  command->add_option("--engine", a->engine, "What runs the network: auto, xnnpack, opencv, onnxruntime [auto]")
      ->check(CLI::IsMember({"auto", "xnnpack", "opencv", "onnxruntime"}));
  command
      ->add_option("--evaluate", a->evaluate,
                   "Measures the detector on pictures with labels in YOLO's layout: DIR/images, DIR/labels")
      ->type_name("DIR");
  command->add_option("--set", a->set, "Only DIR/images/NAME")->type_name("NAME")->needs("--evaluate");
  command->footer(
      "Examples:\n"
      "  yorb detect photo.jpg holiday/ --save boxes\n"
      "  yorb detect rgbd_dataset_freiburg3_walking_xyz --json > boxes.jsonl    read again by --detections\n"
      "  yorb detect clip.mp4 --model yolov8n.onnx --classes person,dog --conf .4\n"
      "  yorb detect --evaluate my_set --set val --json");
  command->callback([a, &action] { action = [a] { return Detect(*a); }; });
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/yolo_detector.h"

#include <algorithm>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/installed.h"
#include "core/log.h"
#include "core/parallel.h"
#include "detection/class_names.h"
#include "detection/edge_maps.h"
#include "detection/fuse_looks.h"
#include "detection/head_layout.h"
#include "detection/letterbox.h"
#include "detection/people_map.h"

namespace yorb {
namespace {

constexpr size_t kMostBoxes = 300;  // a picture

/// The names of the classes where the file has none: COCO's for 80, else numbers, with a warning.
void NameClasses(int num_classes, Network& network) {
  if (!network.names.empty()) return;
  if (num_classes == static_cast<int>(CocoNames().size())) {
    network.names = CocoNames();
    network.names_source = "COCO";
    return;
  }
  for (int i = 0; i < num_classes; ++i) network.names.push_back("class" + std::to_string(i));
  network.names_source = "their numbers";
  LogWarning("class-names", network.input.path +
                                " carries no class names; its classes are called class0, class1 and so on: " +
                                "write their names, a line each, into " + network.input.path + ".names");
}

/// Whether the sigmoid of raw maps is still to come: as the graph says, else as the numbers look.
bool AreLogits(const Network& network, const HeadLayout& layout, const std::vector<TensorView>& outputs) {
  if (layout.kind == LayoutKind::kEdgeMaps) return AreEdgeMapsLogits(outputs, layout);
  for (const RawMap& map : layout.maps) {
    if (LastOperator(network.model, network.model.outputs[map.output].name) != "Sigmoid")
      return LookLikeLogits(outputs, layout);
  }
  return false;
}

/// What the network sees: scaled and framed, in colours of its order or grey.
cv::Mat InputOf(const ImageSet& images, const Letterbox& fit, const EngineInput& input) {
  const bool has_colour = input.channels == 3 && !images.colour.empty();
  const cv::Mat framed = Letterboxed(has_colour ? images.colour : images.grey, fit);
  if (input.channels == 1 || (has_colour && input.is_bgr)) return framed;
  cv::Mat rgb;
  cv::cvtColor(framed, rgb, has_colour ? cv::COLOR_BGR2RGB : cv::COLOR_GRAY2RGB);
  return rgb;
}

/// Left becomes right.
ImageSet Mirrored(const ImageSet& images) {
  constexpr int kAboutTheVertical = 1;
  ImageSet mirrored;
  cv::flip(images.grey, mirrored.grey, kAboutTheVertical);
  if (!images.colour.empty()) cv::flip(images.colour, mirrored.colour, kAboutTheVertical);
  return mirrored;
}

void Mirror(double width_px, std::vector<Box>& boxes) {
  for (Box& box : boxes) {
    const double left = box.left;
    box.left = width_px - box.right, box.right = width_px - left;
  }
}

}  // namespace

ImageSet ImageSetOf(const cv::Mat& bgr) {
  ImageSet images;
  if (bgr.channels() == 1) {
    images.grey = bgr;
  } else {
    images.colour = bgr;
    cv::cvtColor(bgr, images.grey, cv::COLOR_BGR2GRAY);
  }
  return images;
}

Result<std::string> DefaultNetwork() {
  const auto folder = InstalledFolder("models");
  const std::string path = (std::filesystem::path(folder.value_or("models")) / "yolo_mo.onnx").string();
  std::error_code ignored;
  if (folder && std::filesystem::exists(path, ignored)) return path;
  return BadInput(path + ", the network that comes with yorb, is not there; name another one (--model FILE.onnx)");
}

namespace {

/// More threads than the machine runs at once wait for one another at every step, which takes many times as long.
DetectionOptions WithThreadsThatRun(DetectionOptions options) {
  const int most = NumHardwareThreads();
  if (options.threads > most) {
    LogWarning("detection-threads", "detection.threads is " + std::to_string(options.threads) +
                                        ", and this machine runs " + std::to_string(most) +
                                        " at once: the network takes " + std::to_string(most));
    options.threads = most;
  }
  return options;
}

}  // namespace

Result<std::unique_ptr<YoloDetector>> YoloDetector::Open(const DetectionOptions& wanted) {
  const DetectionOptions options = WithThreadsThatRun(wanted);
  if ((options.width > 0) != (options.height > 0))
    return BadInput(
        "detection.width and detection.height go together; 0 for both takes the size that the network's file says");
  const auto path = options.model.empty() ? DefaultNetwork() : Result<std::string>(options.model);
  if (!path) return path.error();
  auto network = OpenNetwork(*path, {options.width, options.height});
  if (!network) return network.error();
  auto shaped = MakeShapedEngine(*network, options);
  if (!shaped) return shaped.error();
  const HeadLayout& layout = shaped->layout;
  const HeadFacts facts = FactsOf(shaped->blank_outputs, *network);
  NameClasses(layout.num_classes, *network);

  std::unique_ptr<YoloDetector> detector(new YoloDetector());
  detector->options_ = options;
  detector->decode_.confidence = options.confidence;
  detector->decode_.is_logits = AreLogits(*network, layout, shaped->blank_outputs);
  detector->decode_.anchors = network->anchors.empty() ? StandardAnchors() : network->anchors;
  if (detector->decode_.anchors.size() < 6 * layout.maps.size())
    return BadInput(*path + " has " + std::to_string(layout.maps.size()) +
                    " raw maps and too few anchors in its metadata");
  detector->names_ = network->names;
  detector->has_people_ = network->has_people;
  LogInfo(*path + ": " + LayoutText(layout, facts) + (detector->decode_.is_logits ? " of logits" : "") + ", input " +
          std::to_string(facts.width) + "x" + std::to_string(facts.height) +
          (shaped->input.is_bgr ? " of B, G, R from 0 to 255, " : ", ") + std::to_string(detector->names_.size()) +
          " classes named by " + network->names_source + (network->has_people ? ", and a map of people" : "") +
          ", run by " + shaped->engine->name());
  detector->ReadOnlyWhatCounts(*shaped);
  detector->own_ = *std::move(shaped);
  return detector;
}

std::string YoloDetector::NameOf(int label) const {
  const auto index = static_cast<size_t>(label);
  return index < names_.size() ? names_[index] : "class" + std::to_string(label);
}

void YoloDetector::ReadOnlyWhatCounts(ShapedEngine& shaped) const {
  for (const RawMap& map : shaped.layout.maps) {
    if (map.anchor_axis != 0) continue;
    const int64_t num_channels = shaped.blank_outputs[map.output].dims[static_cast<size_t>(map.value_axis)];
    const ObjectnessRead read = ObjectnessOf(num_channels, decode_);
    shaped.engine->ReadOnly({map.output, read.channels, read.least});
  }
}

Status YoloDetector::FitToPictures(std::vector<int> long_sides_px) {
  // A box that one look of several is little sure of still counts for what the others saw.
  constexpr double kFaint = .01;
  const bool is_asked_for = !long_sides_px.empty();
  const auto of_one_size = [&] {
    return BadInput(own_.input.path + " runs at its own size of " + std::to_string(own_.input.width) + "x" +
                    std::to_string(own_.input.height) + " alone; leave --size out, or export the network with another");
  };
  if (own_.layout.kind != LayoutKind::kRawMaps) return is_asked_for ? Status(of_one_size()) : Status::Ok();
  auto network = OpenNetwork(own_.input.path, {});
  if (!network) return network.error();
  if (!is_asked_for) long_sides_px = network->stills_px;
  if (long_sides_px.empty()) return Status::Ok();
  options_.engine = own_.engine->name() == "OpenCV DNN" ? "opencv" : "xnnpack";  // those that do not mind the size
  const int first_px = long_sides_px.front();
  stills_ = *std::move(network);
  if (!EngineFor({first_px, first_px}, first_px)) {
    stills_.reset();
    return is_asked_for ? Status(of_one_size()) : Status::Ok();
  }
  if (long_sides_px.size() > 1) decode_.confidence = std::min(decode_.confidence, kFaint);
  ReadOnlyWhatCounts(own_);
  others_.clear();  // they read only what counted before
  std::string sides;
  for (const int side_px : long_sides_px) sides += (sides.empty() ? "" : ", ") + std::to_string(side_px);
  LogInfo(own_.input.path + ": pictures are looked at in their own shape, the longer side of " + sides + " px");
  long_sides_px_ = std::move(long_sides_px);
  return Status::Ok();
}

Result<ShapedEngine*> YoloDetector::EngineFor(const cv::Size& picture, int long_side_px) {
  const cv::Size size = InputSizeFor(picture, long_side_px);
  if (size == own_.size()) return &own_;
  const auto found =
      std::find_if(others_.begin(), others_.end(), [&](const auto& other) { return other->size() == size; });
  if (found != others_.end()) {
    std::rotate(found, found + 1, others_.end());
    return others_.back().get();
  }
  stills_->input.width = size.width, stills_->input.height = size.height;
  auto made = MakeShapedEngine(*stills_, options_);
  if (!made) return made.error();
  if (made->layout.kind != own_.layout.kind || made->layout.num_classes != own_.layout.num_classes)
    return BadInput(own_.input.path + " gives something else at another size");
  if (others_.size() == kMostLooks) others_.erase(others_.begin());
  ReadOnlyWhatCounts(*made);
  others_.push_back(std::make_unique<ShapedEngine>(*std::move(made)));
  return others_.back().get();
}

Result<std::vector<RawBox>> YoloDetector::Decode(const std::vector<TensorView>& outputs, const HeadLayout& layout) {
  constexpr double kWeak = .05;
  auto boxes = DecodeBoxes(outputs, layout, decode_);
  if (!boxes) return BadInput(own_.input.path + " " + boxes.error().message);
  if (is_in_pixels_ || boxes->empty() || layout.kind == LayoutKind::kRawMaps || layout.kind == LayoutKind::kEdgeMaps)
    return boxes;
  is_in_pixels_ = !LookLikeFractions(*boxes);
  if (is_in_pixels_) return boxes;
  DecodeOptions weak = decode_;
  weak.confidence = std::min(weak.confidence, kWeak);
  const auto all = DecodeBoxes(outputs, layout, weak);
  if (!all || !LookLikeFractions(*all)) return boxes;
  return BadInput(own_.input.path +
                  ": its boxes look like fractions of the picture, for none of them reaches beyond 1.5 px; export it "
                  "with boxes in pixels");
}

Result<std::vector<Box>> YoloDetector::Look(const ImageSet& images, ShapedEngine& shaped, cv::Mat* people) {
  const auto& [input, engine, layout, blank_outputs] = shaped;
  const Letterbox fit = FitLetterbox(images.grey.size(), shaped.size());
  const auto outputs = RunOn(*engine, InputOf(images, fit, input));
  if (!outputs) return outputs.error();
  if (has_people_ && people != nullptr) *people = PeopleIn(outputs->back(), fit);
  if (layout.kind == LayoutKind::kCornerRows && !HaveClassNumbers((*outputs)[layout.output]))
    return BadInput(input.path + " is no detector that is read: the last numbers of its rows, " +
                    ShapeText((*outputs)[layout.output].dims) +
                    ", are no classes; end-to-end rows are corners, confidence and class number");
  auto raw_boxes = Decode(*outputs, layout);
  if (!raw_boxes) return raw_boxes.error();
  const double most_overlap =
      layout.kind == LayoutKind::kCornerRows && !layout.has_all_rows ? 1.0 : options_.most_overlap;
  std::vector<Box> boxes;
  for (const RawBox& raw : SuppressDoubles(*std::move(raw_boxes), most_overlap, kMostBoxes)) {
    const Box whole{NameOf(raw.label),         raw.confidence,
                    fit.ToPictureX(raw.left),  fit.ToPictureY(raw.top),
                    fit.ToPictureX(raw.right), fit.ToPictureY(raw.bottom)};
    Box box = Cut(whole, fit.picture.width, fit.picture.height);
    if (HasArea(box)) boxes.push_back(std::move(box));
  }
  return boxes;
}

Result<std::vector<Box>> YoloDetector::LookAtStill(const ImageSet& images) {
  constexpr double kSameThing = .5;  // overlap (IoU) from which on evaluations take two boxes for one thing
  std::vector<ShapedEngine*> engines, distinct;
  for (const int side_px : long_sides_px_) {
    const auto shaped = EngineFor(images.grey.size(), side_px);
    if (!shaped) return shaped.error();
    engines.push_back(*shaped);
    if (std::find(distinct.begin(), distinct.end(), *shaped) == distinct.end()) distinct.push_back(*shaped);
  }
  if (engines.size() == 1) return Look(images, *engines.front());
  const ImageSet mirrored = Mirrored(images);
  std::vector<Result<std::vector<Box>>> looks(engines.size(), std::vector<Box>());
  const auto look = [&](size_t i) {
    const bool is_mirrored = i % 2 == 1;
    looks[i] = Look(is_mirrored ? mirrored : images, *engines[i]);
    if (is_mirrored && looks[i]) Mirror(images.grey.cols, *looks[i]);
  };
  ParallelFor(distinct.size(), NumHardwareThreads(), [&](size_t k) {
    // An engine runs on one thread at a time. The largest, usually the last one, begins.
    const ShapedEngine* mine = distinct[distinct.size() - 1 - k];
    for (size_t i = 0; i < engines.size(); ++i) {
      if (engines[i] == mine) look(i);
    }
  });
  std::vector<std::vector<Box>> seen;
  for (auto& boxes : looks) {
    if (!boxes) return boxes;
    seen.push_back(*std::move(boxes));
  }
  std::vector<Box> boxes = FuseLooks(seen, kSameThing);
  const auto is_weak = [&](const Box& box) { return box.confidence < options_.confidence; };
  boxes.erase(std::remove_if(boxes.begin(), boxes.end(), is_weak), boxes.end());
  if (boxes.size() > kMostBoxes) boxes.resize(kMostBoxes);
  return boxes;
}

Result<Detections> YoloDetector::Detect(const ImageSet& images) {
  Detections detections;
  auto boxes = stills_ ? LookAtStill(images) : Look(images, own_, &detections.people);
  if (!boxes) return boxes.error();
  detections.boxes = *std::move(boxes);
  return detections;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/bench_detector.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/picture_size.h"
#include "apps/sequence_arguments.h"
#include "apps/signals.h"
#include "core/files.h"
#include "detection/yolo_detector.h"
#include "experiments/detector.h"
#include "pictures/picture_folder.h"
#include "runs/run_folder.h"

namespace yorb {
namespace {

constexpr long long kMostRounds = 1000000;

struct DetectorArguments {
  std::vector<std::string> models, sequences;
  std::optional<std::string> labelled, size, pictures, out, rounds;
  std::string set;
  bool wants_json = false;
};

/// The networks in the order of the command line; ours first where none is named.
Result<std::vector<std::string>> ModelsOf(const DetectorArguments& arguments) {
  if (!arguments.models.empty()) return arguments.models;
  const auto ours = DefaultNetwork();
  if (!ours) return ours.error();
  return std::vector<std::string>{*ours};
}

/// The pictures that figures are made of.
Result<std::vector<std::string>> PicturesOf(const DetectorArguments& arguments) {
  constexpr size_t kMostFigures = 12;
  std::vector<std::string> pictures;
  if (!arguments.pictures) return pictures;
  if (!arguments.out) return BadInput("--pictures needs --out, a folder for the figures");
  pictures = PicturesUnder(*arguments.pictures);
  if (pictures.empty()) return BadInput("--pictures " + *arguments.pictures + " holds no pictures");
  pictures.resize(std::min(pictures.size(), kMostFigures));
  return pictures;
}

Result<DetectorBenchOptions> OptionsOf(const DetectorArguments& arguments) {
  DetectorBenchOptions options;
  const auto rounds = WholeNumber("--rounds", arguments.rounds, static_cast<long long>(options.rounds), 1, kMostRounds);
  if (!rounds) return rounds.error();
  options.rounds = static_cast<size_t>(*rounds);
  const auto models = ModelsOf(arguments);
  if (!models) return models.error();
  const auto size = ReadPictureSize(arguments.size);
  if (!size) return size.error();
  options.models = *models;
  options.size = *size;
  options.labelled = arguments.labelled;
  options.set = arguments.set;
  options.sequences = arguments.sequences;
  options.should_stop = IsStopAsked;
  return options;
}

Status Bench(const DetectorArguments& arguments) {
  const auto options = OptionsOf(arguments);
  if (!options) return options.error();
  const auto pictures = PicturesOf(arguments);
  if (!pictures) return pictures.error();
  if (arguments.out) {
    if (Status usable = PrepareRunFolder(*arguments.out); !usable) return usable;
  }
  const auto report = MeasureDetectors(*options);
  if (!report) return report.error();
  std::fputs((arguments.wants_json ? DetectorJson(*report) : DetectorText(*report)).c_str(), stdout);
  Unreadable unreadable = report->unreadable();
  if (!arguments.out) return unreadable.Told();
  auto figures = DetectorFigures(*pictures, *options, *arguments.out);
  if (!figures) return figures.error();
  figures->files.push_back({*arguments.out + "/detector.txt", DetectorText(*report)});
  figures->files.push_back({*arguments.out + "/detector.json", DetectorJson(*report)});
  if (const Status written = WriteFilesTogether(figures->files); !written) return written;
  unreadable.Add(figures->unreadable);
  return unreadable.Told();
}

}  // namespace

void AddBenchDetector(CLI::App& bench, Action& action) {
  CLI::App* command = bench.add_subcommand("detector", "The paper's tables 1, 2 and 7 and figure 9 for any networks");
  const auto a = std::make_shared<DetectorArguments>();
  command->add_option("MODELS", a->models, "ONNX files [models/yolo_mo.onnx]")->type_name("FILE");
  command->add_option("--evaluate", a->labelled, "Labelled pictures in YOLO's layout: recall, precision, mAP")
      ->type_name("DIR");
  command->add_option("--set", a->set, "Only DIR/images/NAME")->type_name("NAME")->needs("--evaluate");
  command
      ->add_option("--sequence", a->sequences,
                   "A sequence with a people.txt: how many of its people are found; may be given often")
      ->allow_extra_args(false)
      ->type_name("DIR");
  command->add_option("--size", a->size, "Of all networks' inputs, multiples of 32 [as each file says]")
      ->type_name("WxH");
  command->add_option("--rounds", a->rounds, "Timed runs of each network [30]")->type_name("N");
  command->add_option("--pictures", a->pictures, "Pictures that figure 9 shows as every network sees them")
      ->type_name("DIR");
  command->add_option("--out", a->out, "A folder for the tables, the JSON and the figures")->type_name("DIR");
  command->add_flag("--json", a->wants_json, "JSON on standard output");
  command->footer(
      "Examples:\n"
      "  yorb bench detector models/yolo_mo.onnx models/yolo_mo_n.onnx yolov5n.onnx --size 320x256\n"
      "  yorb bench detector yolov5n.onnx models/yolo_mo.onnx --evaluate my_set --set val --pictures rooms --out "
      "bench");
  command->callback([a, &action] {
    action = [a] {
      CatchSignals();
      const Status status = Bench(*a);
      return status ? ExitCodeAfterSignal(kExitDone) : Complain(status.error());
    };
  });
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/bench_light.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/progress.h"
#include "apps/sequence_arguments.h"
#include "apps/signals.h"
#include "core/files.h"
#include "core/text.h"
#include "experiments/light_text.h"
#include "runs/run_folder.h"

namespace yorb {
namespace {

constexpr long long kMostSeeds = 1000;

struct LightArguments {
  SequenceArguments sequence;
  std::vector<std::string> lights;
  std::optional<std::string> seeds, out;
  bool wants_json = false;
};

Result<std::vector<LightKind>> LightsOf(const std::vector<std::string>& names) {
  std::vector<LightKind> lights;
  for (const std::string& name : names.empty() ? LightNames() : names) {
    const auto light = ParseLight(name);
    if (!light)
      return BadInput("--light: " + name + " is no light; did you mean " + NearestWord(name, LightNames()) + "?");
    lights.push_back(*light);
  }
  return lights;
}

Status WriteResults(const std::string& folder, const LightReport& report) {
  const auto in_folder = [&](const std::string& name) { return (std::filesystem::path(folder) / name).string(); };
  std::vector<FileToWrite> files = {{in_folder("light.txt"), LightText(report)},
                                    {in_folder("light.json"), LightJson(report)}};
  std::vector<LightKind> drawn;
  for (const LightRun& run : report.runs) {
    if (std::find(drawn.begin(), drawn.end(), run.light) != drawn.end()) continue;
    drawn.push_back(run.light);
    files.push_back({in_folder("light_" + ToString(run.light) + ".svg"), LightSheet(report, run.light)});
  }
  return WriteFilesTogether(files);
}

Result<LightReport> Measure(const LightArguments& arguments) {
  const auto lights = LightsOf(arguments.lights);
  if (!lights) return lights.error();
  const auto seeds = WholeNumber("--seeds", arguments.seeds, 1, 1, kMostSeeds);
  if (!seeds) return seeds.error();
  const auto sequence = OpenSequence(arguments.sequence);
  if (!sequence) return sequence.error();
  const auto truth = ReadTruthBeside(sequence->folder);
  if (!truth) return truth.error();
  if (arguments.out) {
    if (const Status usable = PrepareRunFolder(*arguments.out); !usable) return usable.error();
  }
  Progress progress(arguments.wants_json);
  LightBenchHooks hooks;
  hooks.should_stop = IsStopAsked;
  hooks.on_frame = [&](size_t num_done, size_t num_frames) { progress.Show(num_done, num_frames); };
  hooks.on_run = [&](const LightRun& run) {
    progress.End();
    if (arguments.wants_json) return;
    std::fputs(LightRunText(run).c_str(), stdout);
    std::fflush(stdout);
  };
  auto report = MeasureLight(*sequence->dataset, {sequence->config, *lights, static_cast<int>(*seeds), *truth}, hooks);
  progress.End();
  return report;
}

int Light(const LightArguments& arguments) {
  CatchSignals();
  const auto report = Measure(arguments);
  if (!report) return Complain(report.error());
  std::fputs((arguments.wants_json ? LightJson(*report) : "\n" + LightText(*report)).c_str(), stdout);
  if (arguments.out) {
    const Status written = WriteResults(*arguments.out, *report);
    if (!written) return Complain(written.error());
  }
  return ExitCodeAfterSignal(kExitDone);
}

}  // namespace

void AddBenchLight(CLI::App& bench, Action& action) {
  CLI::App* light = bench.add_subcommand("light", "SLAM in changing light: the original front end beside ours");
  const auto arguments = std::make_shared<LightArguments>();
  const char* const kNothingRemoved = "this bench compares features, and removes nothing";
  const char* const kNewMaps = "every run of this bench begins a new map";
  arguments->sequence.AddTo(*light, {{"--mode", "mode", "all runs of this bench are inline", "inline"},
                                     {"--dynamics", "dynamics", kNothingRemoved, "off"},
                                     {"--detections", "detections", kNothingRemoved},
                                     {"--masks", "masks", kNothingRemoved},
                                     {"--model", "detection.model", kNothingRemoved},
                                     {"", "load_map", kNewMaps},
                                     {"", "localize_only", kNewMaps}});
  light
      ->add_option("--light", arguments->lights,
                   "ramp, flicker, switch, shade or dim, beside steady; may be given often; left out: all")
      ->allow_extra_args(false)
      ->type_name("KIND");
  light->add_option("--seeds", arguments->seeds, "So many runs of each, with seeds of their own");
  light->add_option("--out", arguments->out, "A folder for the table, the JSON, and a plot over time of each light");
  light->add_flag("--json", arguments->wants_json, "JSON on standard output");
  light->footer(
      "The light changes while the pictures are read, with a sensor's noise; depth and truth stay. All runs are\n"
      "inline. Errors need a groundtruth.txt beside the pictures.\n"
      "Examples:\n"
      "  yorb bench light rgbd_dataset_freiburg1_xyz --out plots\n"
      "  yorb bench light my_room --camera my_camera.yaml --light switch --light dim --seeds 5 --json");
  light->callback([arguments, &action] { action = [arguments] { return Light(*arguments); }; });
}

}  // namespace yorb

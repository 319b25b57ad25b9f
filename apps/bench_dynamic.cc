// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/bench_dynamic.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/progress.h"
#include "apps/sequence_arguments.h"
#include "apps/signals.h"
#include "core/files.h"
#include "core/text.h"
#include "experiments/dynamic_figures.h"
#include "experiments/dynamic_text.h"
#include "runs/run_folder.h"

namespace yorb {
namespace {

constexpr long long kMostRuns = 1000;

struct DynamicArguments {
  SequenceArguments sequences;  ///< its places are several folders
  std::vector<std::string> ways;
  std::optional<std::string> runs, out;
  bool wants_json = false;
};

/// The sequences, and what keeps them open.
struct Opened {
  std::vector<OpenedSequence> open;
  std::vector<DynamicSequence> sequences;
  Config config;
};

Status CheckArguments(const DynamicArguments& arguments) {
  for (const std::string& way : arguments.ways) {
    if (std::find(DynamicWays().begin(), DynamicWays().end(), way) != DynamicWays().end()) continue;
    return BadInput("--way: " + way + " is none; did you mean " + NearestWord(way, DynamicWays()) + "?");
  }
  return Status::Ok();
}

/// The path of what stands beside the pictures; empty where it is not there.
std::string Beside(const std::string& folder, const std::string& name) {
  std::error_code ignored;
  const std::filesystem::path path = std::filesystem::path(folder) / name;
  return std::filesystem::exists(path, ignored) ? path.string() : "";
}

/// Whether boxes of people.txt were asked for by name.
bool WantsBoxes(const DynamicArguments& arguments) {
  return std::count(arguments.ways.begin(), arguments.ways.end(), "full-exact") > 0;
}

Result<Opened> OpenAll(const DynamicArguments& arguments) {
  Opened opened;
  for (const std::string& folder : arguments.sequences.places) {
    SequenceArguments one = arguments.sequences;
    one.places = {folder};
    one.settings.insert(one.settings.begin(), "mode=inline");  // repeats to the bit, unless something else is asked for
    auto sequence = OpenSequence(one);
    if (!sequence) return sequence.error();
    auto truth = ReadTruthBeside(sequence->folder);
    if (!truth) return truth.error();
    const std::string name = OwnName(folder);
    for (const DynamicSequence& other : opened.sequences) {
      if (other.name == name)
        return BadInput("two sequences are called " + name + "; rename a folder, or name it once");
    }
    const std::string boxes = Beside(folder, "people.txt");
    if (boxes.empty() && WantsBoxes(arguments))
      return BadInput(folder + " has no people.txt with the boxes that --way full-exact needs");
    opened.config = sequence->config;
    opened.sequences.push_back({name, sequence->dataset.get(), *std::move(truth), boxes, Beside(folder, "mask")});
    opened.open.push_back(*std::move(sequence));
  }
  return opened;
}

Result<DynamicReport> Measure(const DynamicArguments& arguments, const Opened& opened, int num_runs) {
  Progress progress(arguments.wants_json);
  DynamicBenchHooks hooks;
  hooks.should_stop = IsStopAsked;
  hooks.on_frame = [&](size_t num_done, size_t num_frames) { progress.Show(num_done, num_frames); };
  hooks.on_run = [&](const DynamicRun& run) {
    progress.End();
    if (arguments.wants_json) return;
    std::fputs(DynamicRunText(run).c_str(), stdout);
    std::fflush(stdout);
  };
  auto report = MeasureDynamic(opened.sequences, {opened.config, arguments.ways, num_runs}, hooks);
  progress.End();
  return report;
}

int Dynamic(const DynamicArguments& arguments) {
  CatchSignals();
  if (const Status fine = CheckArguments(arguments); !fine) return Complain(fine.error());
  const auto num_runs = WholeNumber("--runs", arguments.runs, 1, 1, kMostRuns);
  if (!num_runs) return Complain(num_runs.error());
  const auto opened = OpenAll(arguments);
  if (!opened) return Complain(opened.error());
  if (arguments.out) {
    if (const Status usable = PrepareRunFolder(*arguments.out); !usable) return Complain(usable.error());
  }
  const auto report = Measure(arguments, *opened, static_cast<int>(*num_runs));
  if (!report) return Complain(report.error());
  std::fputs((arguments.wants_json ? DynamicJson(*report) : "\n" + DynamicText(*report)).c_str(), stdout);
  if (arguments.out) {
    const Status written = WriteFilesTogether(DynamicFiles(*report, opened->sequences, *arguments.out));
    if (!written) return Complain(written.error());
  }
  if (report->error) return Complain(*report->error);  // after all that was measured until then
  return ExitCodeAfterSignal(kExitDone);
}

}  // namespace

void AddBenchDynamic(CLI::App& bench, Action& action) {
  CLI::App* dynamic = bench.add_subcommand("dynamic", "SLAM among people: what removing moving points is worth");
  const auto arguments = std::make_shared<DynamicArguments>();
  const char* const kNewMaps = "every run of this bench begins a new map";
  arguments->sequences.AddTo(
      *dynamic, {{"--dynamics", "dynamics", "is what this bench compares; choose with --way"},
                 {"--detections", "detections", "not taken here; full-exact finds people.txt beside the pictures"},
                 {"", "load_map", kNewMaps},
                 {"", "localize_only", kNewMaps}});
  dynamic
      ->add_option("--way", arguments->ways,
                   "original (ORB-SLAM2's front end, nothing removed: the measure), off, paper, full, or full-exact "
                   "(with the boxes of people.txt); may be given often; left out: all")
      ->allow_extra_args(false)
      ->type_name("WAY");
  dynamic->add_option("--runs", arguments->runs, "So many of each, with seeds from --seed (1) on");
  dynamic->add_option("--out", arguments->out, "A folder for the tables, the JSON, and figures (SVG, PNG)");
  dynamic->add_flag("--json", arguments->wants_json, "JSON on standard output");
  dynamic->footer(
      "Several sequences may be named. Beside the pictures, groundtruth.txt gives errors, people.txt the boxes of\n"
      "full-exact, and mask/ precision and recall of the removal. Runs are inline unless --mode says otherwise.\n"
      "TUM's sequences with people stand beside what was published; tools/get_tum.sh downloads them.\n"
      "Examples:\n"
      "  yorb bench dynamic rgbd_dataset_freiburg3_walking_xyz rgbd_dataset_freiburg3_sitting_static --runs 5\n"
      "  yorb bench dynamic my_office --camera my_camera.yaml --way off --way full --out figures");
  dynamic->callback([arguments, &action] { action = [arguments] { return Dynamic(*arguments); }; });
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "apps/command.h"
#include "apps/progress.h"
#include "apps/sequence_arguments.h"
#include "apps/signals.h"
#include "core/log.h"
#include "core/text.h"
#include "runs/run.h"
#include "runs/run_folder.h"

namespace yorb {
namespace {

struct RunArguments {
  SequenceArguments sequence;
  std::optional<std::string> out;
  std::string overlay;
  std::optional<std::string> save_map, load_map;
  bool localizes_only = false;
  bool is_quiet = false;
};

void PrintSummary(const RunSummary& summary) {
  const double share =
      summary.frames == 0 ? 0 : 100.0 * static_cast<double>(summary.tracked) / static_cast<double>(summary.frames);
  std::printf("%zu of %zu frames tracked (%s %%), %zu keyframes, %zu landmarks, %s s\n", summary.tracked,
              summary.frames, FormatFixed(share, 1).c_str(), summary.keyframes, summary.landmarks,
              FormatFixed(summary.wall_s, 1).c_str());
  if (summary.skipped > 0) std::printf("%zu pictures could not be read and were skipped\n", summary.skipped);
  if (summary.dropped > 0) std::printf("%zu frames came too fast and were dropped\n", summary.dropped);
  if (!summary.map.empty()) std::printf("map in %s\n", summary.map.c_str());
  std::printf("results in %s: trajectory.txt keyframes.txt metrics.json frames.csv report.html\n", summary.out.c_str());
}

/// The options about maps are settings, so that config.yaml has them; they win over `--set`.
Result<OpenedSequence> Open(const RunArguments& arguments) {
  SequenceArguments sequence = arguments.sequence;
  if (arguments.load_map) sequence.settings.push_back("load_map=" + *arguments.load_map);
  if (arguments.localizes_only) sequence.settings.push_back("localize_only=true");
  return OpenSequence(sequence);
}

/// What is read must not give way to a result of the same name: a config.yaml of one's own, with `--out .` say. That of
/// an older run in the folder may, as all of that run does.
Status CheckInputsKept(const RunArguments& arguments) {
  if (!arguments.out) return Status::Ok();
  std::error_code ignored;
  const SequenceArguments& given = arguments.sequence;
  const bool has_older_run = std::filesystem::exists(InRunFolder(*arguments.out, "metrics.json"), ignored);
  const std::pair<const char*, const std::optional<std::string>&> inputs[] = {
      {"--config", given.config}, {"--camera", given.camera}, {"--detections", given.detections}};
  for (const auto& [option, path] : inputs) {
    if (!path || (has_older_run && std::string(option) == "--config")) continue;
    const std::string written = std::filesystem::path(*path).filename().string();
    if (IsResultName(written) && std::filesystem::equivalent(*path, InRunFolder(*arguments.out, written), ignored))
      return BadInput(std::string(option) + " " + *path + " would be overwritten by the run's own " + written +
                      "; name another folder with --out, or rename the file");
  }
  return Status::Ok();
}

Result<RunSummary> RunAsAsked(const RunArguments& arguments) {
  if (const Status kept = CheckInputsKept(arguments); !kept) return kept.error();
  auto sequence = Open(arguments);
  if (!sequence) return sequence.error();
  RunOptions options;
  options.config = sequence->config;
  options.out = arguments.out.value_or("");
  options.overlay = arguments.overlay;
  options.save_map = arguments.save_map.value_or("");
  options.title = std::filesystem::path(sequence->folder).lexically_normal().string();
  auto truth = ReadTruthBeside(sequence->folder);
  if (truth) options.reference = *std::move(truth);
  if (!truth) LogInfo("left out of the report: " + truth.error().message);  // no reason not to run
  Progress progress(arguments.is_quiet);
  RunHooks hooks;
  hooks.should_stop = IsStopAsked;
  hooks.on_progress = [&](const RunProgress& now) { progress.Show(now.num_done, now.num_frames); };
  auto summary = RunSequence(*sequence->dataset, options, hooks);
  progress.End();
  return summary;
}

int Run(const RunArguments& arguments) {
  CatchSignals();
  const Status started = StartLog({.keeps_text = true});
  if (!started) return Complain(started.error());
  const auto summary = RunAsAsked(arguments);
  const Status stopped = StopLog();
  if (!summary) return Complain(summary.error());
  if (!arguments.is_quiet) PrintSummary(*summary);
  if (summary->error) return Complain(*summary->error);
  if (!stopped) return Complain(stopped.error());
  return summary->was_stopped ? ExitCodeAfterSignal(kExitDone) : kExitDone;
}

}  // namespace

void AddRunCommand(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("run", "Runs SLAM on a recorded sequence and writes trajectory, figures and report");
  const auto arguments = std::make_shared<RunArguments>();
  arguments->sequence.AddTo(*command);
  command->add_option("--out", arguments->out, "The folder for the results; left out: a new one, yorb_DATE_TIME");
  command->add_option("--save-map", arguments->save_map,
                      "A file for the map, written whole at every end; an older map there is replaced then");
  command->add_option("--load-map", arguments->load_map, "A file of --save-map to go on from; it is only read");
  command->add_flag(
      "--localize-only", arguments->localizes_only,
      "The camera is only located in the map of --load-map, which stays as it is; any folder of pictures will do");
  command->add_option("--save-overlay", arguments->overlay,
                      "A folder for a PNG of each frame with its boxes and points, and points.csv");
  command->add_flag("--quiet", arguments->is_quiet, "Nothing on standard output; warnings still go to standard error");
  command->footer(
      "Examples:\n"
      "  yorb run rgbd_dataset_freiburg1_xyz\n"
      "  yorb run my_room --camera my_camera.yaml --out results\n"
      "  yorb run my_room --camera tum_fr1 --mode inline --seed 3 --set features.wanted=1500\n"
      "  yorb run my_room --config results/config.yaml --out again     the same run, to the bit if it was inline\n"
      "  yorb run monday --save-map office.map; yorb run tuesday --load-map office.map --save-map office.map\n"
      "  yorb run photos --load-map office.map --localize-only\n"
      "Ctrl-C ends a run early; everything computed so far is written.");
  command->callback([arguments, &action] { action = [arguments] { return Run(*arguments); }; });
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/dynamic.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/log.h"
#include "core/stopwatch.h"
#include "datasets/masked_dataset.h"
#include "experiments/features_front_ends.h"
#include "runs/feed.h"
#include "runs/make_detector.h"
#include "system/slam.h"

namespace yorb {
namespace {

/// One run that is to be done.
struct DynamicTask {
  const DynamicSequence* sequence = nullptr;
  std::string way;
  int64_t seed = 0;
};

std::vector<DynamicTask> TasksOf(const std::vector<DynamicSequence>& sequences, const DynamicBenchOptions& options) {
  std::vector<DynamicTask> tasks;
  for (const DynamicSequence& sequence : sequences) {
    for (const std::string& way : DynamicWays()) {
      const bool is_wanted =
          options.ways.empty() || std::find(options.ways.begin(), options.ways.end(), way) != options.ways.end();
      if (!is_wanted || (way == dynamic_way::kFullExact && sequence.people.empty())) continue;
      for (int k = 0; k < options.num_runs; ++k) tasks.push_back({&sequence, way, options.config.seed + k});
    }
  }
  return tasks;
}

Config ConfigOf(const DynamicTask& task, Config config) {
  config.seed = task.seed;
  config.dynamics = "off";
  config.detections.clear();
  if (task.way == dynamic_way::kOriginal) config.features = OriginalOptions(config.features, 20, 7);
  if (task.way == dynamic_way::kPaper) config.dynamics = "paper";
  if (task.way == dynamic_way::kFull || task.way == dynamic_way::kFullExact) config.dynamics = "full";
  if (task.way == dynamic_way::kFullExact) config.detections = task.sequence->people;
  return config;
}

std::optional<Evaluation> EvaluationOf(const Trajectory& truth, const Trajectory& estimate) {
  if (truth.empty() || estimate.empty()) return std::nullopt;
  auto evaluation = Evaluate({"truth", truth, true, {}}, {"estimate", estimate, true, {}}, EvalOptions());
  if (!evaluation) return std::nullopt;
  return *std::move(evaluation);
}

DynamicRun RunOf(const DynamicTask& task, const FeedLog& fed, SlamReport report) {
  DynamicRun run;
  run.sequence = task.sequence->name;
  run.way = task.way;
  run.seed = task.seed;
  run.num_frames = fed.fates.size();
  const auto num_frames = static_cast<double>(std::max<size_t>(1, run.num_frames));
  run.coverage = static_cast<double>(report.trajectory().size()) / num_frames;
  for (const FrameRecord& record : report.frames) {
    run.num_removed += record.num_removed / num_frames;
    run.num_given_back += record.num_given_back / num_frames;
  }
  run.evaluation = EvaluationOf(task.sequence->truth, report.trajectory());
  run.stage_ms = std::move(report.stage_ms);
  return run;
}

/// Nothing where it was stopped on the way.
Result<std::optional<DynamicRun>> RunTask(const DynamicTask& task, const Config& config, const FeedHooks& hooks) {
  const Stopwatch watch;
  const DynamicSequence& sequence = *task.sequence;
  std::unique_ptr<MaskedDataset> masked;
  if (!config.masks.empty()) {
    auto opened = MaskedDataset::Open(*sequence.dataset, config.masks);
    if (!opened) return opened.error();
    masked = *std::move(opened);
  }
  const Dataset& dataset = masked ? *masked : *sequence.dataset;
  auto parts = MakeParts(config, dataset);
  if (!parts) return parts.error();
  const auto judged = std::make_shared<JudgedPoints>();
  if (!sequence.masks.empty()) parts->slam.watch = [judged](const Watched& watched) { judged->Add(watched); };
  auto slam = Slam::Create(config, dataset.rig(), std::move(parts->slam));
  if (!slam) return slam.error();
  const FeedLog fed = Feed(dataset, config, **slam, hooks);
  if (fed.error) return *fed.error;
  if (fed.was_stopped) return std::optional<DynamicRun>();

  DynamicRun run = RunOf(task, fed, (*slam)->Report());
  run.wall_s = watch.seconds();
  if (!sequence.masks.empty()) {
    const auto score = ScoreRemoval(*judged, *sequence.dataset, sequence.masks);
    if (!score) return score.error();
    run.removal = *score;
  }
  return std::optional<DynamicRun>(std::move(run));
}

/// Finds faults of boxes, masks and networks before the first run rather than after some hours.
Status CheckTasks(const std::vector<DynamicTask>& tasks, const DynamicBenchOptions& options) {
  for (const DynamicTask& task : tasks) {
    if (task.seed != options.config.seed) continue;
    const auto parts = MakeParts(ConfigOf(task, options.config), *task.sequence->dataset);
    if (!parts) return parts.error();
    if (options.config.masks.empty()) continue;
    const auto masked = MaskedDataset::Open(*task.sequence->dataset, options.config.masks);
    if (!masked) return masked.error();
  }
  return Status::Ok();
}

/// Without a truth there are no errors to compare, which somebody who waits for hours should know before.
void WarnOfMissingTruth(const std::vector<DynamicSequence>& sequences) {
  for (const DynamicSequence& sequence : sequences) {
    if (sequence.truth.empty())
      LogWarning("bench-truth",
                 sequence.name + " has no groundtruth.txt: its runs have a coverage and times, no errors");
  }
}

/// A folder that is called mask and holds something else is no fault.
std::vector<DynamicSequence> WithoutForeignMasks(std::vector<DynamicSequence> sequences) {
  for (DynamicSequence& sequence : sequences) {
    if (sequence.masks.empty()) continue;
    const auto none = ScoreRemoval({}, *sequence.dataset, sequence.masks);
    if (none) continue;
    LogWarning("bench-masks",
               sequence.masks +
                   " is not used, so that nothing is said of how rightly points are removed: " + none.error().message);
    sequence.masks.clear();
  }
  return sequences;
}

size_t FramesOf(const std::vector<DynamicTask>& tasks, const Config& config) {
  size_t num_frames = 0;
  for (const DynamicTask& task : tasks) num_frames += FramesToFeed(*task.sequence->dataset, config);
  return num_frames;
}

}  // namespace

const std::vector<std::string>& DynamicWays() {
  static const std::vector<std::string> ways = {dynamic_way::kOriginal, dynamic_way::kOff, dynamic_way::kPaper,
                                                dynamic_way::kFull, dynamic_way::kFullExact};
  return ways;
}

Result<DynamicReport> MeasureDynamic(const std::vector<DynamicSequence>& sequences, const DynamicBenchOptions& options,
                                     const DynamicBenchHooks& hooks) {
  const std::vector<DynamicSequence> known = WithoutForeignMasks(sequences);
  const std::vector<DynamicTask> tasks = TasksOf(known, options);
  if (const Status fine = CheckTasks(tasks, options); !fine) return fine.error();
  WarnOfMissingTruth(known);
  const size_t num_frames = FramesOf(tasks, options.config);
  size_t num_done = 0;  // in runs that are over
  DynamicReport report;
  for (const DynamicTask& task : tasks) {
    FeedHooks feed_hooks;
    feed_hooks.should_stop = hooks.should_stop;
    feed_hooks.after_frame = [&](const FeedLog& fed) {
      if (hooks.on_frame) hooks.on_frame(num_done + fed.fates.size(), num_frames);
    };
    auto run = RunTask(task, ConfigOf(task, options.config), feed_hooks);
    if (!run && report.runs.empty()) return run.error();
    if (!run) report.error = run.error();
    report.was_stopped = run && !*run;
    if (report.error || report.was_stopped) return report;
    num_done += (*run)->num_frames;
    report.runs.push_back(**std::move(run));
    if (hooks.on_run) hooks.on_run(report.runs.back());
  }
  return report;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/light.h"

#include <algorithm>
#include <limits>
#include <opencv2/core.hpp>

#include "core/stopwatch.h"
#include "datasets/light_dataset.h"
#include "evaluation/evaluate.h"
#include "runs/feed.h"
#include "runs/results.h"
#include "system/slam.h"

namespace yorb {
namespace {

/// A recording that notes how bright its pictures are.
class BrightnessNotes : public Dataset {
 public:
  BrightnessNotes(const Dataset& source, std::vector<double>& notes) : source_(source), notes_(notes) {}

  size_t size() const override { return source_.size(); }
  Timestamp TimeOf(size_t i) const override { return source_.TimeOf(i); }
  std::string PictureName(size_t i) const override { return source_.PictureName(i); }
  const Rig& rig() const override { return source_.rig(); }
  Result<LoadedFrame> Load(size_t i) const override {
    auto frame = source_.Load(i);
    // A frame's note is written by whoever reads the frame, and looked at when the run is over.
    if (frame && frame->images) notes_[i] = cv::mean(frame->images->grey)[0];
    return frame;
  }

 private:
  const Dataset& source_;
  std::vector<double>& notes_;
};

std::vector<LightKind> WithSteadyFirst(const std::vector<LightKind>& lights) {
  std::vector<LightKind> all = {LightKind::kSteady};
  for (const LightKind light : lights) {
    if (std::find(all.begin(), all.end(), light) == all.end()) all.push_back(light);
  }
  return all;
}

std::optional<double> AteOf(const Trajectory& truth, const Trajectory& estimate) {
  if (truth.empty() || estimate.empty()) return std::nullopt;
  const auto evaluation = Evaluate({"truth", truth, true, {}}, {"estimate", estimate, true, {}}, EvalOptions());
  if (!evaluation) return std::nullopt;
  return evaluation->ate.summary.rmse;
}

/// One run that is to be done.
struct LightTask {
  LightKind light = LightKind::kSteady;
  NamedFeatures front_end;
  int64_t seed = 0;
};

std::vector<LightTask> TasksOf(const LightBenchOptions& options) {
  std::vector<LightTask> tasks;
  for (const LightKind light : WithSteadyFirst(options.lights)) {
    for (const NamedFeatures& front_end : LightFrontEnds(options.config.features)) {
      for (int k = 0; k < options.num_seeds; ++k) tasks.push_back({light, front_end, options.config.seed + k});
    }
  }
  return tasks;
}

std::vector<LightFrame> FramesOf(const std::vector<FrameRow>& rows, Timestamp start,
                                 const std::vector<double>& brightness) {
  std::vector<LightFrame> frames;
  for (size_t i = 0; i < rows.size(); ++i) {
    const FrameRecord& record = rows[i].record;
    const bool is_tracked = rows[i].state == ToString(TrackingState::kTracking);
    frames.push_back({SecondsBetween(start, record.timestamp), brightness[i], record.num_extracted,
                      is_tracked ? record.num_inliers : 0});
  }
  return frames;
}

/// Nothing where it was stopped on the way.
Result<std::optional<LightRun>> RunTask(const Dataset& dataset, const LightTask& task, const LightBenchOptions& options,
                                        const FeedHooks& hooks) {
  const Stopwatch watch;
  Config config = options.config;
  config.mode = "inline";
  config.dynamics = "off";
  config.seed = task.seed;
  config.features = task.front_end.features;
  // Steady light means the recording as it is; the others bring the noise that goes with less light.
  const double noise = task.light == LightKind::kSteady ? 0 : 1;
  const LightDataset changed(dataset, {task.light, noise, static_cast<uint64_t>(task.seed)});
  std::vector<double> brightness(dataset.size(), std::numeric_limits<double>::quiet_NaN());
  const BrightnessNotes noted(changed, brightness);
  auto slam = Slam::Create(config, dataset.rig());
  if (!slam) return slam.error();
  const FeedLog fed = Feed(noted, config, **slam, hooks);
  if (fed.error) return *fed.error;
  if (fed.was_stopped) return std::optional<LightRun>();

  const SlamReport report = (*slam)->Report();
  LightRun run{task.light, task.front_end.name, task.seed, {}, 0, AteOf(options.truth, report.trajectory()), 0};
  run.frames = FramesOf(FrameRows(dataset, fed.fates, report.frames), dataset.TimeOf(0), brightness);
  if (!run.frames.empty())
    run.coverage = static_cast<double>(report.trajectory().size()) / static_cast<double>(run.frames.size());
  run.wall_s = watch.seconds();
  return std::optional<LightRun>(std::move(run));
}

}  // namespace

std::vector<NamedFeatures> LightFrontEnds(const FeatureOptions& ours) {
  FeatureOptions original = ours;
  original.detector = "fixed";
  original.distribution = "quadtree";
  original.fast_arc = 9;
  original.subpixel = false;
  original.fixed_threshold = 20;
  original.fixed_threshold_low = 7;
  FeatureOptions paper = original;
  paper.fixed_threshold = 40;
  paper.fixed_threshold_low = 30;
  return {{"original 20/7", original}, {"original 40/30", paper}, {"ours", ours}};
}

Result<LightReport> MeasureLight(const Dataset& dataset, const LightBenchOptions& options,
                                 const LightBenchHooks& hooks) {
  const std::vector<LightTask> tasks = TasksOf(options);
  const size_t num_frames = FramesToFeed(dataset, options.config);
  LightReport report;
  for (const LightTask& task : tasks) {
    FeedHooks feed_hooks;
    feed_hooks.should_stop = hooks.should_stop;
    feed_hooks.after_frame = [&](const FeedLog& fed) {
      if (hooks.on_frame) hooks.on_frame(report.runs.size() * num_frames + fed.fates.size(), tasks.size() * num_frames);
    };
    auto run = RunTask(dataset, task, options, feed_hooks);
    if (!run) return run.error();
    if (!*run) {
      report.was_stopped = true;
      return report;
    }
    report.runs.push_back(**std::move(run));
    if (hooks.on_run) hooks.on_run(report.runs.back());
  }
  return report;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/speed.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <opencv2/features2d.hpp>
#include <utility>

#include "core/stopwatch.h"
#include "core/text.h"
#include "datasets/masked_dataset.h"
#include "experiments/one_thread.h"
#include "experiments/text_table.h"
#include "runs/feed.h"
#include "runs/make_detector.h"
#include "runs/results.h"
#include "runs/run_map.h"
#include "runs/stage_json.h"
#include "system/slam.h"

namespace yorb {
namespace {

constexpr size_t kOrbPictures = 50;  // before the run, and as many after it
constexpr int kOrbFeatures = 1000;

/// Milliseconds of cv::ORB on pictures spread over the recording.
std::vector<double> TimeOrb(const Dataset& dataset, size_t num_frames, const std::function<bool()>& should_stop) {
  const auto orb = cv::ORB::create(kOrbFeatures);
  std::vector<double> times_ms;
  const size_t step = std::max<size_t>(1, num_frames / kOrbPictures);
  for (size_t i = 0; i < num_frames && !(should_stop && should_stop()); i += step) {
    const auto loaded = dataset.Load(i);
    if (!loaded || !loaded->images) continue;
    std::vector<cv::KeyPoint> keypoints;
    cv::Mat descriptors;
    const Stopwatch watch;
    orb->detectAndCompute(loaded->images->grey, cv::noArray(), keypoints, descriptors);
    times_ms.push_back(watch.ms());
  }
  return times_ms;
}

const ReportStage* FindStage(const std::vector<ReportStage>& stages, const std::string& name) {
  const auto found = std::find_if(stages.begin(), stages.end(), [&](const ReportStage& s) { return s.name == name; });
  return found == stages.end() ? nullptr : &*found;
}

std::vector<std::string> RowOf(const ReportStage& stage) {
  return {stage.name, FormatFixed(stage.median_ms, 2), FormatFixed(stage.p95_ms, 2), FormatFixed(stage.max_ms, 2),
          std::to_string(stage.count)};
}

Result<SpeedReport> MeasureUnmasked(const Dataset& dataset, const Config& config,
                                    const std::function<bool()>& should_stop) {
  const OneThread one_thread;
  const size_t num_frames = FramesToFeed(dataset, config);
  auto parts = MakeParts(config, dataset);
  if (!parts) return parts.error();
  auto slam = Slam::Create(config, dataset.rig(), std::move(parts->slam));
  if (!slam) return slam.error();
  std::vector<double> orb_ms = TimeOrb(dataset, num_frames, should_stop);
  FeedHooks hooks;
  hooks.should_stop = should_stop;
  const FeedLog fed = Feed(dataset, config, **slam, hooks);
  if (fed.error) return *fed.error;
  const std::vector<double> after_ms = TimeOrb(dataset, num_frames, should_stop);
  orb_ms.insert(orb_ms.end(), after_ms.begin(), after_ms.end());

  SlamReport ran = (*slam)->Report();
  ran.stage_ms["read"] = fed.read_ms;
  SpeedReport report;
  report.frames = fed.fates.size();
  report.tracked = ran.trajectory().size();
  report.mode = config.mode;
  report.dynamics = config.dynamics;
  report.stages = StageTimes(ran.stage_ms);
  report.cv_orb = TimesOf("cv::ORB(1000)", orb_ms);
  return report;
}

}  // namespace

double SpeedReport::Ratio() const {
  const ReportStage* total = FindStage(stages, "frame_total");
  if (total == nullptr || total->count == 0 || cv_orb.count == 0) return std::numeric_limits<double>::quiet_NaN();
  return total->median_ms / cv_orb.median_ms;
}

Result<SpeedReport> MeasureSpeed(const Dataset& dataset, const Config& config,
                                 const std::function<bool()>& should_stop) {
  if (const Status valid = CheckMapOptions(config, ""); !valid) return valid.error();
  if (config.masks.empty()) return MeasureUnmasked(dataset, config, should_stop);
  const auto masked = MaskedDataset::Open(dataset, config.masks);
  if (!masked) return masked.error();
  return MeasureUnmasked(**masked, config, should_stop);
}

std::string SpeedText(const SpeedReport& report) {
  std::vector<std::vector<std::string>> rows{{"", "median ms", "p95 ms", "max ms", "count"}};
  for (const ReportStage& stage : report.stages) {
    if (stage.count > 0) rows.push_back(RowOf(stage));
  }
  rows.push_back(RowOf(report.cv_orb));
  std::string text = std::to_string(report.tracked) + " of " + std::to_string(report.frames) +
                     " frames tracked, mode " + report.mode + ", dynamics " + report.dynamics + "\n" +
                     TextTable(rows, 1);
  const double ratio = report.Ratio();
  if (ratio == ratio)
    text += "a whole frame takes " + FormatFixed(ratio, 2) + " times as long as cv::ORB(1000) alone\n";
  return text;
}

std::string SpeedJson(const SpeedReport& report) {
  const nlohmann::ordered_json json = {{"frames", report.frames},
                                       {"tracked", report.tracked},
                                       {"mode", report.mode},
                                       {"dynamics", report.dynamics},
                                       {"stages", StagesJson(report.stages)},
                                       {"cv_orb", StageJson(report.cv_orb)},
                                       {"ratio", NumberOrNull(report.Ratio())}};
  return json.dump(2) + "\n";
}

}  // namespace yorb

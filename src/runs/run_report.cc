// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/run_report.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/text.h"
#include "runs/version.h"

namespace yorb {
namespace {

std::vector<std::pair<std::string, std::string>> KeyFigures(const RunMetrics& metrics,
                                                            const std::vector<ReportStage>& stages) {
  std::vector<std::pair<std::string, std::string>> figures = {
      {"frames", std::to_string(metrics.frames)},
      {"tracked", std::to_string(metrics.tracked)},
      {"keyframes", std::to_string(metrics.keyframes)},
      {"landmarks", std::to_string(metrics.landmarks)},
      {"wall time", FormatFixed(metrics.wall_s, 1) + " s"},
      {"peak memory", FormatFixed(metrics.peak_rss_mb, 0) + " MB"},
      {"mode", metrics.mode},
  };
  if (metrics.skipped > 0) figures.insert(figures.begin() + 2, {"skipped", std::to_string(metrics.skipped)});
  const auto total = std::find_if(stages.begin(), stages.end(), [](const auto& s) { return s.name == "frame_total"; });
  if (total != stages.end() && total->count > 0) {
    figures.insert(figures.end() - 3, {"median frame", FormatFixed(total->median_ms, 1) + " ms"});
  }
  return figures;
}

ReportFrame FrameOf(const FrameRow& row) {
  return {row.record.timestamp, row.state, row.record.num_matched, row.record.num_inliers, row.record.frame_total_ms};
}

}  // namespace

RunReport ReportOf(const RunOptions& options, const RunMetrics& metrics, const std::vector<FrameRow>& rows,
                   const SlamReport& slam) {
  RunReport report;
  report.title = options.title;
  report.stages = StageTimes(metrics.stage_ms);
  report.key_figures = KeyFigures(metrics, report.stages);
  report.trajectory = slam.trajectory();
  report.keyframes = slam.keyframes();
  report.reference = options.reference;
  report.frames.reserve(rows.size());
  for (const FrameRow& row : rows) report.frames.push_back(FrameOf(row));
  if (metrics.frames > 0) report.coverage = metrics.Coverage();
  report.config_digest = metrics.config_digest;
  report.version = Version();
  return report;
}

}  // namespace yorb

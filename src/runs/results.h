// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "evaluation/report.h"
#include "runs/feed.h"
#include "system/slam.h"

namespace yorb {

/// One line of frames.csv: a colour picture of the list, whatever became of it.
struct FrameRow {
  std::string state;   ///< tracking, recently_lost, lost, not_initialized, skipped or dropped
  FrameRecord record;  ///< only the time stamp counts for skipped and dropped ones
};

/// The pictures as far as they were worked off: what went in, joined with what came out, by time stamps.
std::vector<FrameRow> FrameRows(const Dataset& dataset, const std::vector<Fate>& fates,
                                const std::vector<FrameRecord>& records);

/// frames.csv.
std::string FramesCsv(const std::vector<FrameRow>& rows);

/// What metrics.json says of moving things.
struct DynamicsMetrics {
  std::string mode;
  size_t boxes = 0;            ///< of moving things, over all frames
  size_t boxes_unmatched = 0;  ///< of a box file, that fit no frame
  size_t frames_with_boxes = 0, frames_bridged = 0;
  size_t points_removed = 0, points_given_back = 0;
  size_t landmarks_removed = 0;  ///< that turned out to move
};

/// The counts of all frames.
DynamicsMetrics DynamicsOf(const std::string& mode, const std::vector<FrameRecord>& frames);

/// What metrics.json says of a run.
struct RunMetrics {
  size_t frames = 0;   ///< colour pictures of the list, as far as the run went
  size_t tracked = 0;  ///< of these, with a pose confirmed by matches
  size_t keyframes = 0, landmarks = 0, loops = 0;
  size_t submaps = 0;  ///< that were not joined; coverage counts the frames of the largest
  size_t skipped = 0;  ///< pictures that could not be decoded whole
  DynamicsMetrics dynamics;
  double wall_s = 0, cpu_s = 0, peak_rss_mb = 0;
  std::map<std::string, std::vector<double>> stage_ms;
  int64_t seed = 0;
  std::string mode, config_digest;

  /// Share of the frames that were tracked; NaN without frames.
  double Coverage() const;
};

/// metrics.json: strict JSON, with null where nothing can be said.
std::string MetricsJson(const RunMetrics& metrics);

/// Median, 95 %, maximum and count of one stage's times.
ReportStage TimesOf(const std::string& name, const std::vector<double>& ms);

/// The same of each stage, those that every run has first.
std::vector<ReportStage> StageTimes(const std::map<std::string, std::vector<double>>& stage_ms);

}  // namespace yorb

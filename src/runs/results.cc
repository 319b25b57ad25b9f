// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/results.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/stats.h"
#include "core/text.h"
#include "runs/stage_json.h"
#include "runs/version.h"

namespace yorb {
namespace {

/// The stages that metrics.json always names, in this order; further ones follow by name.
constexpr const char* kStages[] = {"extract", "detect", "remove", "track", "frame_total", "local_ba"};

FrameRow RowWithout(Timestamp time, const char* state) {
  FrameRow row;
  row.state = state;
  row.record.timestamp = time;
  return row;
}

nlohmann::ordered_json DynamicsJson(const DynamicsMetrics& metrics) {
  return {{"mode", metrics.mode},
          {"boxes", metrics.boxes},
          {"boxes_unmatched", metrics.boxes_unmatched},
          {"frames_with_boxes", metrics.frames_with_boxes},
          {"frames_bridged", metrics.frames_bridged},
          {"points_removed", metrics.points_removed},
          {"points_given_back", metrics.points_given_back},
          {"landmarks_removed", metrics.landmarks_removed}};
}

void AppendRow(std::string& text, const FrameRow& row) {
  const FrameRecord& r = row.record;
  text += ToString(r.timestamp) + "," + row.state;
  for (const int count :
       {r.num_extracted, r.num_static, r.num_removed, r.num_given_back, r.num_matched, r.num_inliers}) {
    text += "," + std::to_string(count);
  }
  text += r.is_keyframe ? ",1" : ",0";
  for (const double ms : {r.extract_ms, r.detect_ms, r.remove_ms, r.track_ms, r.frame_total_ms}) {
    text += "," + FormatFixed(ms, 3);
  }
  text += "\n";
}

}  // namespace

std::vector<FrameRow> FrameRows(const Dataset& dataset, const std::vector<Fate>& fates,
                                const std::vector<FrameRecord>& records) {
  std::vector<FrameRow> rows;
  rows.reserve(fates.size());
  auto record = records.begin();
  for (size_t i = 0; i < fates.size(); ++i) {
    const Timestamp time = dataset.TimeOf(i);
    if (fates[i] != Fate::kPushed) {
      rows.push_back(RowWithout(time, fates[i] == Fate::kSkipped ? "skipped" : "dropped"));
      continue;
    }
    while (record != records.end() && record->timestamp < time) ++record;
    if (record == records.end()) break;  // it and all later ones are still in work
    const bool is_in = record->timestamp == time;
    rows.push_back(is_in ? FrameRow{ToString(record->state), *record} : RowWithout(time, "dropped"));
  }
  return rows;
}

std::string FramesCsv(const std::vector<FrameRow>& rows) {
  std::string text =
      "timestamp,state,extracted,static,removed,given_back,matched,inliers,keyframe,"
      "extract_ms,detect_ms,remove_ms,track_ms,frame_total_ms\n";
  for (const FrameRow& row : rows) AppendRow(text, row);
  return text;
}

DynamicsMetrics DynamicsOf(const std::string& mode, const std::vector<FrameRecord>& frames) {
  DynamicsMetrics metrics;
  metrics.mode = mode;
  for (const FrameRecord& frame : frames) {
    metrics.boxes += static_cast<size_t>(frame.num_boxes);
    metrics.frames_with_boxes += frame.num_boxes > 0;
    metrics.frames_bridged += frame.num_bridged > 0;
    metrics.points_removed += static_cast<size_t>(frame.num_removed);
    metrics.points_given_back += static_cast<size_t>(frame.num_given_back);
  }
  return metrics;
}

double RunMetrics::Coverage() const {
  if (frames == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(tracked) / static_cast<double>(frames);
}

ReportStage TimesOf(const std::string& name, const std::vector<double>& ms) {
  if (ms.empty()) return {name, 0, 0, 0, 0};
  return {name, Quantile(ms, 0.5), Quantile(ms, 0.95), *std::max_element(ms.begin(), ms.end()), ms.size()};
}

std::vector<ReportStage> StageTimes(const std::map<std::string, std::vector<double>>& stage_ms) {
  std::vector<ReportStage> stages;
  for (const char* name : kStages) {
    const auto found = stage_ms.find(name);
    stages.push_back(TimesOf(name, found == stage_ms.end() ? std::vector<double>() : found->second));
  }
  for (const auto& [name, ms] : stage_ms) {
    if (std::find(std::begin(kStages), std::end(kStages), name) == std::end(kStages))
      stages.push_back(TimesOf(name, ms));
  }
  return stages;
}

std::string MetricsJson(const RunMetrics& metrics) {
  const nlohmann::ordered_json json = {{"frames", metrics.frames},
                                       {"tracked", metrics.tracked},
                                       {"coverage", NumberOrNull(metrics.Coverage())},
                                       {"skipped", metrics.skipped},
                                       {"keyframes", metrics.keyframes},
                                       {"landmarks", metrics.landmarks},
                                       {"loops", metrics.loops},
                                       {"submaps", metrics.submaps},
                                       {"dynamics", DynamicsJson(metrics.dynamics)},
                                       {"wall_s", NumberOrNull(metrics.wall_s)},
                                       {"cpu_s", NumberOrNull(metrics.cpu_s)},
                                       {"peak_rss_mb", NumberOrNull(metrics.peak_rss_mb)},
                                       {"stages", StagesJson(StageTimes(metrics.stage_ms))},
                                       {"seed", metrics.seed},
                                       {"mode", metrics.mode},
                                       {"version", Version()},
                                       {"config_digest", metrics.config_digest}};
  return json.dump(2) + "\n";
}

}  // namespace yorb

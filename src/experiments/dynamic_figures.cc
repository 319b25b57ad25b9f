// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/dynamic_figures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/log.h"
#include "core/text.h"
#include "evaluation/chart_png.h"
#include "evaluation/trajectory_charts.h"
#include "experiments/bar_chart.h"
#include "experiments/dynamic_published.h"
#include "experiments/dynamic_rows.h"
#include "experiments/dynamic_text.h"
#include "experiments/text_table.h"

namespace yorb {
namespace {

constexpr double kPngZoom = 2;
constexpr int kTrackWidth_px = 560;
const char* const kPublishedColor = "#7a8292";

std::string ColorOf(const std::string& way) {
  const auto place = std::find(DynamicWays().begin(), DynamicWays().end(), way) - DynamicWays().begin();
  return ChartPalette()[static_cast<size_t>(place) % ChartPalette().size()];
}

bool IsWay(const std::string& name) {
  return std::find(DynamicWays().begin(), DynamicWays().end(), name) != DynamicWays().end();
}

/// Charts in rows of two.
std::vector<std::vector<Chart>> InPairs(const std::vector<Chart>& charts) {
  std::vector<std::vector<Chart>> rows;
  for (const Chart& chart : charts) {
    if (rows.empty() || rows.back().size() == 2) rows.emplace_back();
    rows.back().push_back(chart);
  }
  return rows;
}

/// " (-12.3 %)" against the measure; nothing where there is none.
std::string ChangeText(double reduction_share) {
  if (!std::isfinite(reduction_share)) return "";
  return " (" + std::string(reduction_share < 0 ? "+" : "-") + FormatFixed(std::abs(100 * reduction_share), 1) + " %)";
}

/// The truth for as long as the pictures of a run.
Trajectory TruthOf(const DynamicSequence& sequence, size_t num_frames) {
  if (num_frames == 0) return {};
  const Timestamp first = sequence.dataset->TimeOf(0), last = sequence.dataset->TimeOf(num_frames - 1);
  Trajectory truth;
  for (const StampedPose& pose : sequence.truth) {
    if (first <= pose.timestamp && pose.timestamp <= last) truth.push_back(pose);
  }
  return truth;
}

/// The tracks of each way beside the truth, and all errors over time; nothing where no run has an error.
std::string TracksSvg(const std::vector<DynamicRow>& rows, const DynamicSequence& sequence) {
  std::vector<Chart> tracks;
  TrajectoryChartInput all;
  std::vector<NamedErrors> errors;
  for (const DynamicRow& row : rows) {
    if (row.sequence != sequence.name || !row.runs.front()->evaluation) continue;
    const Evaluation& evaluation = *row.runs.front()->evaluation;
    all.reference = TruthOf(sequence, row.runs.front()->num_frames);
    Chart track = TopViewChart({all.reference, {{row.way, evaluation.aligned}}, {}});
    track.title = row.way + ": RMSE " + NumberCell(evaluation.ate.summary.rmse, 4) + " m";
    track.width_px = track.height_px = kTrackWidth_px;
    for (ChartSeries& series : track.series) {
      if (series.name == row.way) series.color = ColorOf(row.way);
    }
    tracks.push_back(std::move(track));
    all.estimates.push_back({row.way, evaluation.aligned});
    NamedErrors error{row.way, {}, evaluation.ate.errors};
    for (const StampPair& pair : evaluation.pairs) error.stamps.push_back(evaluation.aligned[pair.second].timestamp);
    errors.push_back(std::move(error));
  }
  if (tracks.empty()) return "";
  std::vector<std::vector<Chart>> sheet = InPairs(tracks);
  Chart over_time = ErrorChart(all, errors);
  over_time.width_px = 2 * kTrackWidth_px;
  for (ChartSeries& series : over_time.series) {
    if (IsWay(series.name)) series.color = ColorOf(series.name);
  }
  sheet.push_back({std::move(over_time)});
  return ChartSheetSvg(sequence.name + ": tracks beside the truth", sheet);
}

std::string ErrorBarsSvg(const std::vector<DynamicRow>& rows) {
  BarChart chart{"Absolute error; pale: published by others, not measured here", "ATE RMSE, m", true, {}};
  for (const std::string& sequence : SequencesOf(rows)) {
    BarGroup group{sequence, {}};
    for (const DynamicRow& row : rows) {
      if (row.sequence != sequence) continue;
      std::string text = NumberCell(row.ate_m.rmse, 4);
      if (row.way != dynamic_way::kOriginal) text += ChangeText(row.reduction_share.rmse);
      text += ", coverage " + NumberCell(100 * row.coverage, 1) + " %";
      group.bars.push_back({row.way, row.ate_m.rmse, text, ColorOf(row.way), false});
    }
    for (const PublishedFigure& figure : PublishedErrors(sequence)) {
      group.bars.push_back(
          {figure.system, figure.value, NumberCell(figure.value, 4) + ", published", kPublishedColor, true});
    }
    chart.groups.push_back(std::move(group));
  }
  return BarChartSvg(chart);
}

std::string TimeBarsSvg(const std::vector<DynamicRow>& rows) {
  BarChart chart{"Time a frame; pale: published by others on their machines", "ms, median", true, {}};
  for (const std::string& sequence : SequencesOf(rows)) {
    BarGroup group{sequence, {}};
    for (const DynamicRow& row : rows) {
      const auto total = row.stage_ms.find("frame_total");
      if (row.sequence != sequence || total == row.stage_ms.end()) continue;
      group.bars.push_back({row.way, total->second, NumberCell(total->second, 1) + " ms", ColorOf(row.way), false});
    }
    chart.groups.push_back(std::move(group));
  }
  BarGroup published{"TUM sequences with people, published", {}};
  for (const PublishedFigure& figure : PublishedTimes()) {
    const std::string text = NumberCell(figure.value, 1) + " ms, " + figure.note;
    published.bars.push_back({figure.system, figure.value, text, kPublishedColor, true});
  }
  chart.groups.push_back(std::move(published));
  return BarChartSvg(chart);
}

}  // namespace

std::vector<FileToWrite> DynamicFiles(const DynamicReport& report, const std::vector<DynamicSequence>& sequences,
                                      const std::string& folder) {
  const auto in_folder = [&](const std::string& name) { return (std::filesystem::path(folder) / name).string(); };
  const std::vector<DynamicRow> rows = DynamicRows(report);
  std::vector<FileToWrite> files = {{in_folder("dynamic.txt"), DynamicText(report)},
                                    {in_folder("dynamic.json"), DynamicJson(report)}};
  const auto add_drawing = [&](const std::string& name, const std::string& svg) {
    if (svg.empty()) return;
    files.push_back({in_folder(name + ".svg"), svg});
    const auto png = PngFromSvg(svg, kPngZoom);
    if (png) {
      files.push_back({in_folder(name + ".png"), *png});
    } else {
      LogInfo(name + ".png is left out: " + png.error().message);
    }
  };
  add_drawing("dynamic_errors", ErrorBarsSvg(rows));
  add_drawing("dynamic_times", TimeBarsSvg(rows));
  for (const DynamicSequence& sequence : sequences) {
    add_drawing("dynamic_" + sequence.name, TracksSvg(rows, sequence));
  }
  return files;
}

}  // namespace yorb

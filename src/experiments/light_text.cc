// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/light_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.h"
#include "evaluation/chart.h"
#include "experiments/text_table.h"
#include "runs/stage_json.h"

namespace yorb {
namespace {

/// Mean and minimum over frames.
struct MeanAndMin {
  double mean = kNoFigure, min = kNoFigure;
};

/// All seeds of one light and front end together.
struct LightingRow {
  LightKind light = LightKind::kSteady;
  std::string front_end;
  double ate_m = kNoFigure, ate_ratio = kNoFigure, coverage = kNoFigure;
  MeanAndMin features, points;
  std::vector<const LightRun*> runs;
};

double MeanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? kNoFigure : sum / static_cast<double>(values.size());
}

MeanAndMin Over(const std::vector<const LightRun*>& runs, int LightFrame::*count) {
  std::vector<double> values;
  for (const LightRun* run : runs) {
    for (const LightFrame& frame : run->frames) values.push_back(frame.*count);
  }
  if (values.empty()) return {};
  return {MeanOf(values), *std::min_element(values.begin(), values.end())};
}

void Fill(LightingRow& row) {
  std::vector<double> errors, coverages;
  for (const LightRun* run : row.runs) {
    errors.push_back(run->ate_m.value_or(kNoFigure));
    coverages.push_back(run->coverage);
  }
  row.ate_m = MeanOf(errors);
  row.coverage = MeanOf(coverages);
  row.features = Over(row.runs, &LightFrame::num_features);
  row.points = Over(row.runs, &LightFrame::num_points);
}

/// In the order in which they first appear; a run that failed to give an error makes its row's unknown.
std::vector<LightingRow> RowsOf(const LightReport& report) {
  std::vector<LightingRow> rows;
  const auto row_of = [&](LightKind light, const std::string& front_end) {
    return std::find_if(rows.begin(), rows.end(),
                        [&](const LightingRow& row) { return row.light == light && row.front_end == front_end; });
  };
  for (const LightRun& run : report.runs) {
    auto row = row_of(run.light, run.front_end);
    if (row == rows.end()) {
      rows.push_back({run.light, run.front_end, kNoFigure, kNoFigure, kNoFigure, {}, {}, {}});
      row = rows.end() - 1;
    }
    row->runs.push_back(&run);
  }
  for (LightingRow& row : rows) Fill(row);
  for (LightingRow& row : rows) {
    const auto steady = row_of(LightKind::kSteady, row.front_end);
    if (steady != rows.end()) row.ate_ratio = row.ate_m / steady->ate_m;
  }
  return rows;
}

nlohmann::ordered_json Json(const MeanAndMin& value) {
  return {{"mean", NumberOrNull(value.mean)}, {"min", NumberOrNull(value.min)}};
}

/// One chart of a sheet: a value of each frame for each front end.
template <typename ValueOf>
Chart ChartOf(const std::vector<const LightRun*>& runs, const std::string& y_label, ValueOf&& value_of) {
  Chart chart;
  chart.x_label = "s";
  chart.y_label = y_label;
  chart.is_from_zero = true;
  for (const LightRun* run : runs) {
    ChartSeries series;
    series.name = run->front_end;
    for (const LightFrame& frame : run->frames) {
      series.x.push_back(frame.seconds);
      series.y.push_back(value_of(frame));
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace

std::string LightRunText(const LightRun& run) {
  return ToString(run.light) + ", " + run.front_end + ", seed " + std::to_string(run.seed) + ": ATE " +
         NumberCell(run.ate_m.value_or(kNoFigure), 4) + " m, coverage " + FormatFixed(100 * run.coverage, 1) + " %, " +
         FormatFixed(run.wall_s, 1) + " s\n";
}

std::string LightText(const LightReport& report) {
  std::vector<std::vector<std::string>> rows{
      {"light", "front end", "ATE m", "of steady", "coverage %", "features", "min", "tracked", "min"}};
  for (const LightingRow& row : RowsOf(report)) {
    rows.push_back({ToString(row.light), row.front_end, NumberCell(row.ate_m, 4), NumberCell(row.ate_ratio, 2),
                    NumberCell(100 * row.coverage, 1), NumberCell(row.features.mean, 0),
                    NumberCell(row.features.min, 0), NumberCell(row.points.mean, 0), NumberCell(row.points.min, 0)});
  }
  return TextTable(rows, 2);
}

std::string LightJson(const LightReport& report) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  size_t num_seeds = 0;
  for (const LightingRow& row : RowsOf(report)) {
    num_seeds = std::max(num_seeds, row.runs.size());
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    for (const LightRun* run : row.runs) {
      runs.push_back({{"seed", run->seed},
                      {"ate_m", NumberOrNull(run->ate_m.value_or(kNoFigure))},
                      {"coverage", NumberOrNull(run->coverage)}});
    }
    rows.push_back({{"light", ToString(row.light)},
                    {"front_end", row.front_end},
                    {"ate_m", NumberOrNull(row.ate_m)},
                    {"ate_ratio", NumberOrNull(row.ate_ratio)},
                    {"coverage", NumberOrNull(row.coverage)},
                    {"features", Json(row.features)},
                    {"points", Json(row.points)},
                    {"runs", runs}});
  }
  const size_t num_frames = report.runs.empty() ? 0 : report.runs.front().frames.size();
  const nlohmann::ordered_json json = {{"frames", num_frames}, {"seeds", num_seeds}, {"rows", rows}};
  return json.dump(2) + "\n";
}

std::string LightSheet(const LightReport& report, LightKind light) {
  std::vector<const LightRun*> runs;
  for (const LightRun& run : report.runs) {
    if (run.light == light && run.seed == report.runs.front().seed) runs.push_back(&run);
  }
  const std::vector<const LightRun*> one(runs.begin(), runs.begin() + std::min<std::ptrdiff_t>(1, std::ssize(runs)));
  Chart brightness = ChartOf(one, "mean grey level", [](const LightFrame& frame) { return frame.brightness; });
  for (ChartSeries& series : brightness.series) series.name.clear();
  const Chart features = ChartOf(runs, "features found", [](const LightFrame& frame) { return frame.num_features; });
  const Chart points = ChartOf(runs, "points tracked", [](const LightFrame& frame) { return frame.num_points; });
  return ChartSheetSvg("Light: " + ToString(light), {{brightness}, {features}, {points}});
}

}  // namespace yorb

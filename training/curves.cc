// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/curves.h"

#include <algorithm>
#include <map>
#include <vector>

#include "core/text.h"
#include "evaluation/chart.h"

namespace yorb {
namespace {

/// A CSV file with a heading, by columns.
struct Columns {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  size_t Find(const std::string& name) const {
    return static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }
  double Number(size_t row, const std::string& name) const { return ParseDouble(rows[row].at(Find(name))).value_or(0); }
};

Result<Columns> ReadColumns(const std::string& path) {
  const Result<TextFile> file = ReadTextFile(path);
  if (!file) return file.error();
  Columns columns;
  for (const TextLine& line : file->lines) {
    std::vector<std::string> fields;
    for (const std::string_view field : SplitAt(line.text, ',')) fields.emplace_back(field);
    if (columns.names.empty()) {
      columns.names = fields;
    } else if (fields.size() == columns.names.size()) {
      columns.rows.push_back(fields);
    } else {
      return BadInput(file->Where(line) + ": has " + std::to_string(fields.size()) + " fields in place of " +
                      std::to_string(columns.names.size()));
    }
  }
  return columns;
}

/// A column over the progress, each value a mean over as many rows as leave a line that can be read.
ChartSeries Smoothed(const Columns& log, const std::string& name) {
  constexpr size_t kMostPoints = 150;
  const size_t width = std::max<size_t>(1, log.rows.size() / kMostPoints);
  ChartSeries series{.name = name};
  for (size_t first = 0; first + width <= log.rows.size(); first += width) {
    double x = 0, y = 0;
    for (size_t i = first; i < first + width; ++i) {
      x += 100 * log.Number(i, "progress") / static_cast<double>(width);
      y += log.Number(i, name) / static_cast<double>(width);
    }
    series.x.push_back(x);
    series.y.push_back(y);
  }
  return series;
}

Chart LogChart(const Columns& log, const std::string& title, const std::vector<std::string>& names) {
  Chart chart{.title = title, .x_label = "% of the training", .is_from_zero = true, .width_px = 480};
  for (const std::string& name : names) chart.series.push_back(Smoothed(log, name));
  return chart;
}

Chart ScoreChart(const Columns& scores, const std::string& title, const std::string& column) {
  std::map<std::string, ChartSeries> sets;
  for (size_t i = 0; i < scores.rows.size(); ++i) {
    ChartSeries& series = sets[scores.rows[i].at(scores.Find("set"))];
    series.x.push_back(100 * scores.Number(i, "progress"));
    series.y.push_back(scores.Number(i, column));
  }
  Chart chart{.title = title, .x_label = "% of the training", .is_from_zero = true, .width_px = 480};
  for (auto& [name, series] : sets) {
    series.name = name;
    chart.series.push_back(series);
  }
  return chart;
}

}  // namespace

Result<std::string> CurvesSvg(const std::string& folder) {
  const Result<Columns> log = ReadColumns(folder + "/train.csv");
  if (!log) return log.error();
  std::vector<std::vector<Chart>> rows{
      {LogChart(*log, "Losses", {"box", "objectness", "classes"}), LogChart(*log, "Learning rate", {"rate"})}};
  const Result<Columns> scores = ReadColumns(folder + "/scores.csv");
  if (scores && !scores->rows.empty())
    rows.push_back({ScoreChart(*scores, "mAP50", "map50"), ScoreChart(*scores, "AP50 of people", "person_ap50")});
  return ChartSheetSvg("Training", rows);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/dynamic_text.h"

#include <limits>
#include <vector>

#include "core/text.h"
#include "experiments/dynamic_published.h"
#include "experiments/dynamic_rows.h"
#include "experiments/text_table.h"

namespace yorb {
namespace {

using Cells = std::vector<std::string>;

constexpr double kFullCoverage = 0.95;
Cells ReductionCells(const ErrorFigures& share) {
  return {NumberCell(100 * share.rmse, 1), NumberCell(100 * share.mean, 1), NumberCell(100 * share.std, 1)};
}

Cells Joined(Cells first, const Cells& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::string ErrorTable(const std::vector<DynamicRow>& rows) {
  std::vector<Cells> table = {{"sequence", "way", "RMSE m", "+-", "mean m", "s.d. m", "RMSE -%", "mean -%", "s.d. -%",
                               "RPE m/s", "deg/s", "coverage %"}};
  for (const DynamicRow& row : rows) {
    const Cells errors = {row.sequence,
                          row.way,
                          NumberCell(row.ate_m.rmse, 4),
                          NumberCell(row.ate_spread_m, 4),
                          NumberCell(row.ate_m.mean, 4),
                          NumberCell(row.ate_m.std, 4)};
    const bool is_measure = row.way == dynamic_way::kOriginal;
    table.push_back(Joined(Joined(errors, ReductionCells(is_measure ? ErrorFigures() : row.reduction_share)),
                           {NumberCell(row.rpe_m, 4), NumberCell(row.rpe_deg, 3), NumberCell(100 * row.coverage, 1)}));
  }
  if (SequencesOf(rows).size() > 1) {
    for (const AverageReduction& average : AverageReductions(rows)) {
      const Cells name = {"average of " + std::to_string(average.num_sequences), average.way, "", "", "", ""};
      table.push_back(Joined(name, ReductionCells(average.reduction_share)));
    }
  }
  return TextTable(table, 2);
}

/// A word of caution: an error over few frames looks small.
std::string CoverageNote(const std::vector<DynamicRow>& rows) {
  std::string names;
  for (const DynamicRow& row : rows) {
    if (row.coverage < kFullCoverage) names += (names.empty() ? "" : ", ") + row.sequence + " " + row.way;
  }
  return names.empty() ? "" : "Errors of few frames say little; less than 95 % have a pose in: " + names + "\n";
}

/// Empty where nothing was published of any of the sequences.
std::string PublishedTable(const std::vector<DynamicRow>& rows) {
  std::vector<Cells> table = {{"sequence", "system", "RMSE m", ""}};
  bool is_any = false;
  for (const std::string& sequence : SequencesOf(rows)) {
    const std::vector<PublishedFigure> published = PublishedErrors(sequence);
    if (published.empty()) continue;
    is_any = true;
    for (const DynamicRow& row : rows) {
      if (row.sequence != sequence) continue;
      table.push_back({sequence, row.way, NumberCell(row.ate_m.rmse, 4), "measured here"});
    }
    for (const PublishedFigure& figure : published) {
      table.push_back({sequence, figure.system, NumberCell(figure.value, 4), "published"});
    }
  }
  if (!is_any) return "";
  for (const PublishedReduction& paper : PublishedReductions()) {
    table.push_back({paper.sequences + ", average", "YORB-SLAM", "-" + NumberCell(paper.rmse, 2) + " %", "published"});
  }
  return TextTable(table, 2);
}

std::string RemovalTable(const std::vector<DynamicRow>& rows) {
  std::vector<Cells> table = {{"sequence", "way", "removed a picture", "given back", "precision %", "recall %"}};
  for (const DynamicRow& row : rows) {
    table.push_back({row.sequence, row.way, NumberCell(row.num_removed, 1), NumberCell(row.num_given_back, 1),
                     NumberCell(100 * row.precision, 1), NumberCell(100 * row.recall, 1)});
  }
  return TextTable(table, 2);
}

std::string TimeTable(const std::vector<DynamicRow>& rows) {
  const Cells stages = {"extract", "detect", "remove", "track", "frame_total"};
  std::vector<Cells> table = {Joined({"sequence", "way"}, stages)};
  bool is_any_published = false;
  for (const DynamicRow& row : rows) {
    Cells cells = {row.sequence, row.way};
    for (const std::string& stage : stages) {
      const auto found = row.stage_ms.find(stage);
      cells.push_back(NumberCell(found == row.stage_ms.end() ? kNoFigure : found->second, 2));
    }
    table.push_back(cells);
    is_any_published = is_any_published || !PublishedErrors(row.sequence).empty();
  }
  if (is_any_published) {
    for (const PublishedFigure& figure : PublishedTimes()) {
      table.push_back({"published", figure.system, "", "", "", "", NumberCell(figure.value, 1), figure.note});
    }
  }
  return TextTable(table, 2);
}

}  // namespace

std::string DynamicRunText(const DynamicRun& run) {
  return run.sequence + ", " + run.way + ", seed " + std::to_string(run.seed) + ": ATE " +
         NumberCell(run.evaluation ? run.evaluation->ate.summary.rmse : kNoFigure, 4) + " m, coverage " +
         FormatFixed(100 * run.coverage, 1) + " %, " + FormatFixed(run.wall_s, 1) + " s\n";
}

std::string DynamicText(const DynamicReport& report) {
  const std::vector<DynamicRow> rows = DynamicRows(report);
  std::string text =
      "Absolute error (Table 8): means over the runs, +- over the runs, reductions against `original`,\n"
      "which is this program with ORB-SLAM2's front end and nothing removed\n" +
      ErrorTable(rows) + CoverageNote(rows);
  const std::string published = PublishedTable(rows);
  if (!published.empty()) text += "\nBeside other systems (Table 9)\n" + published;
  text += "\nPoints removed, and how rightly by the true masks\n" + RemovalTable(rows);
  text += "\nMilliseconds a frame, medians (Table 10)\n" + TimeTable(rows);
  return text;
}

}  // namespace yorb

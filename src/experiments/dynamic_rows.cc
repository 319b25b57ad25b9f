// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/dynamic_rows.h"

#include <algorithm>
#include <cmath>

#include "core/stats.h"
#include "experiments/text_table.h"

namespace yorb {
namespace {

/// The mean of a figure of each run.
template <typename FigureOf>
double MeanOver(const std::vector<const DynamicRun*>& runs, FigureOf&& figure_of) {
  double sum = 0;
  for (const DynamicRun* run : runs) sum += figure_of(*run);
  return runs.empty() ? kNoFigure : sum / static_cast<double>(runs.size());
}

/// The same of the evaluation.
template <typename FigureOf>
double MeanOfEvaluations(const std::vector<const DynamicRun*>& runs, FigureOf&& figure_of) {
  return MeanOver(runs, [&](const DynamicRun& run) { return run.evaluation ? figure_of(*run.evaluation) : kNoFigure; });
}

void FillErrors(DynamicRow& row) {
  const auto ate = [&](double Summary::*figure) {
    return MeanOfEvaluations(row.runs, [&](const Evaluation& e) { return e.ate.summary.*figure; });
  };
  row.ate_m = {ate(&Summary::rmse), ate(&Summary::mean), ate(&Summary::std)};
  const double variance = MeanOfEvaluations(
      row.runs, [&](const Evaluation& e) { return std::pow(e.ate.summary.rmse - row.ate_m.rmse, 2); });
  row.ate_spread_m = std::sqrt(variance);
  const auto rpe = [](const std::vector<double>& pairs, const Summary& summary) {
    return pairs.empty() ? kNoFigure : summary.rmse;
  };
  row.rpe_m = MeanOfEvaluations(row.runs,
                                [&](const Evaluation& e) { return rpe(e.rpe.translation, e.rpe.translation_summary); });
  row.rpe_deg =
      MeanOfEvaluations(row.runs, [&](const Evaluation& e) { return rpe(e.rpe.rotation_deg, e.rpe.rotation_summary); });
}

void FillRemoval(DynamicRow& row) {
  row.num_removed = MeanOver(row.runs, [](const DynamicRun& run) { return run.num_removed; });
  row.num_given_back = MeanOver(row.runs, [](const DynamicRun& run) { return run.num_given_back; });
  RemovalScore all;
  for (const DynamicRun* run : row.runs) {
    if (!run->removal) continue;
    all.num_removed_rightly += run->removal->num_removed_rightly;
    all.num_removed_wrongly += run->removal->num_removed_wrongly;
    all.num_kept_rightly += run->removal->num_kept_rightly;
    all.num_kept_wrongly += run->removal->num_kept_wrongly;
  }
  row.precision = all.Precision();
  row.recall = all.Recall();
}

void FillTimes(DynamicRow& row) {
  std::map<std::string, std::vector<double>> all;
  for (const DynamicRun* run : row.runs) {
    for (const auto& [stage, times] : run->stage_ms) all[stage].insert(all[stage].end(), times.begin(), times.end());
  }
  for (const auto& [stage, times] : all) {
    if (!times.empty()) row.stage_ms[stage] = Quantile(times, 0.5);
  }
}

ErrorFigures Reduction(const ErrorFigures& from, const ErrorFigures& to) {
  return {1 - to.rmse / from.rmse, 1 - to.mean / from.mean, 1 - to.std / from.std};
}

}  // namespace

std::vector<DynamicRow> DynamicRows(const DynamicReport& report) {
  std::vector<DynamicRow> rows;
  for (const DynamicRun& run : report.runs) {
    if (rows.empty() || rows.back().sequence != run.sequence || rows.back().way != run.way) {
      rows.emplace_back();
      rows.back().sequence = run.sequence;
      rows.back().way = run.way;
    }
    rows.back().runs.push_back(&run);
  }
  for (DynamicRow& row : rows) {
    FillErrors(row);
    row.coverage = MeanOver(row.runs, [](const DynamicRun& run) { return run.coverage; });
    FillRemoval(row);
    FillTimes(row);
  }
  for (DynamicRow& row : rows) {
    const auto measure = std::find_if(rows.begin(), rows.end(), [&](const DynamicRow& other) {
      return other.sequence == row.sequence && other.way == dynamic_way::kOriginal;
    });
    if (measure != rows.end()) row.reduction_share = Reduction(measure->ate_m, row.ate_m);
  }
  return rows;
}

std::vector<AverageReduction> AverageReductions(const std::vector<DynamicRow>& rows) {
  std::vector<AverageReduction> averages;
  for (const std::string& way : DynamicWays()) {
    AverageReduction average{way, 0, {0, 0, 0}};
    for (const DynamicRow& row : rows) {
      if (row.way != way || !std::isfinite(row.reduction_share.rmse)) continue;
      ++average.num_sequences;
      average.reduction_share.rmse += row.reduction_share.rmse;
      average.reduction_share.mean += row.reduction_share.mean;
      average.reduction_share.std += row.reduction_share.std;
    }
    if (average.num_sequences == 0 || way == dynamic_way::kOriginal) continue;
    for (double* figure :
         {&average.reduction_share.rmse, &average.reduction_share.mean, &average.reduction_share.std}) {
      *figure /= static_cast<double>(average.num_sequences);
    }
    averages.push_back(average);
  }
  return averages;
}

std::vector<std::string> SequencesOf(const std::vector<DynamicRow>& rows) {
  std::vector<std::string> names;
  for (const DynamicRow& row : rows) {
    if (std::find(names.begin(), names.end(), row.sequence) == names.end()) names.push_back(row.sequence);
  }
  return names;
}

}  // namespace yorb

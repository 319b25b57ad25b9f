// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <nlohmann/json.hpp>

#include "experiments/dynamic_published.h"
#include "experiments/dynamic_rows.h"
#include "experiments/dynamic_text.h"
#include "runs/stage_json.h"

namespace yorb {
namespace {

using Json = nlohmann::ordered_json;

Json PercentJson(const ErrorFigures& share) {
  return {{"rmse", NumberOrNull(100 * share.rmse)},
          {"mean", NumberOrNull(100 * share.mean)},
          {"std", NumberOrNull(100 * share.std)}};
}

Json RunsJson(const DynamicRow& row) {
  Json runs = Json::array();
  for (const DynamicRun* run : row.runs) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    runs.push_back({{"seed", run->seed},
                    {"ate_m", NumberOrNull(run->evaluation ? run->evaluation->ate.summary.rmse : nothing)},
                    {"coverage", NumberOrNull(run->coverage)}});
  }
  return runs;
}

Json RowJson(const DynamicRow& row) {
  Json stages = Json::object();
  for (const auto& [stage, ms] : row.stage_ms) stages[stage] = NumberOrNull(ms);
  return {{"sequence", row.sequence},
          {"way", row.way},
          {"frames", row.runs.front()->num_frames},
          {"ate_m",
           {{"rmse", NumberOrNull(row.ate_m.rmse)},
            {"mean", NumberOrNull(row.ate_m.mean)},
            {"std", NumberOrNull(row.ate_m.std)},
            {"rmse_spread", NumberOrNull(row.ate_spread_m)}}},
          {"reduction_percent", PercentJson(row.reduction_share)},
          {"rpe", {{"translation_m", NumberOrNull(row.rpe_m)}, {"rotation_deg", NumberOrNull(row.rpe_deg)}}},
          {"coverage", NumberOrNull(row.coverage)},
          {"points", {{"removed", NumberOrNull(row.num_removed)}, {"given_back", NumberOrNull(row.num_given_back)}}},
          {"removal", {{"precision", NumberOrNull(row.precision)}, {"recall", NumberOrNull(row.recall)}}},
          {"stage_ms", stages},
          {"runs", RunsJson(row)}};
}

Json PublishedJson(const std::vector<DynamicRow>& rows) {
  Json errors = Json::array(), times = Json::array(), reductions = Json::array();
  for (const std::string& sequence : SequencesOf(rows)) {
    for (const PublishedFigure& figure : PublishedErrors(sequence)) {
      errors.push_back({{"sequence", sequence}, {"system", figure.system}, {"rmse", figure.value}});
    }
  }
  for (const PublishedFigure& figure : PublishedTimes()) {
    times.push_back({{"system", figure.system}, {"ms", figure.value}, {"note", figure.note}});
  }
  for (const PublishedReduction& paper : PublishedReductions()) {
    reductions.push_back(
        {{"sequences", paper.sequences}, {"rmse", paper.rmse}, {"mean", paper.mean}, {"std", paper.std}});
  }
  return {{"ate_m", errors}, {"frame_ms", times}, {"reduction_percent", reductions}};
}

}  // namespace

std::string DynamicJson(const DynamicReport& report) {
  const std::vector<DynamicRow> rows = DynamicRows(report);
  Json table = Json::array(), averages = Json::array();
  for (const DynamicRow& row : rows) table.push_back(RowJson(row));
  for (const AverageReduction& average : AverageReductions(rows)) {
    averages.push_back({{"way", average.way},
                        {"sequences", average.num_sequences},
                        {"reduction_percent", PercentJson(average.reduction_share)}});
  }
  const Json json = {{"rows", table}, {"averages", averages}, {"published", PublishedJson(rows)}};
  return json.dump(2) + "\n";
}

}  // namespace yorb

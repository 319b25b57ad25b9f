// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/stats.h"
#include "experiments/features.h"
#include "runs/stage_json.h"

namespace yorb {
namespace {

using Json = nlohmann::ordered_json;
using Values = std::map<std::string, std::vector<double>>;

void Merge(const std::map<std::string, Mean>& from, std::map<std::string, Mean>& into) {
  for (const auto& [name, mean] : from) into[name].sum += mean.sum, into[name].count += mean.count;
}

void Merge(const Values& from, Values& into) {
  for (const auto& [name, values] : from) into[name].insert(into[name].end(), values.begin(), values.end());
}

std::vector<LightRow> MergedLight(const std::vector<FeaturesReport>& reports) {
  std::vector<LightRow> rows;
  for (const FeaturesReport& report : reports) {
    if (rows.empty()) {
      rows = report.light;
      continue;
    }
    for (size_t i = 0; i < rows.size(); ++i) {
      Merge(report.light[i].corners, rows[i].corners);
      Merge(report.light[i].features, rows[i].features);
    }
  }
  return rows;
}

Json MeansJson(const std::map<std::string, Mean>& means) {
  Json json = Json::object();
  for (const auto& [name, mean] : means) json[name] = NumberOrNull(mean.value());
  return json;
}

/// {"change", NAME: change of corners, ..., "extracted": {NAME: change of features, ...}} a row.
Json LightJson(const std::vector<LightRow>& rows) {
  Json json = Json::array();
  for (const LightRow& row : rows) {
    Json line = {{"change", row.change}};
    line.update(MeansJson(row.corners));
    line["extracted"] = MeansJson(row.features);
    json.push_back(std::move(line));
  }
  return json;
}

/// {"original_ms", ...}: medians; "original" is ORB-SLAM2's way, as its time is what is compared with.
Json TimesJson(const Values& times_ms) {
  Json json = Json::object();
  for (const auto& [name, ms] : times_ms) {
    const std::string key = name == front_end::kOriginalPath ? "original"
                            : name == front_end::kOriginal   ? "original_points_ours"
                                                             : name;
    if (name != front_end::kOriginalPaper) json[key + "_ms"] = NumberOrNull(Quantile(ms, 0.5));
  }
  return json;
}

Json DispersionJson(const Values& dispersions) {
  Json json = Json::object();
  for (const auto& [name, values] : dispersions) {
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    json[name] = NumberOrNull(values.empty() ? std::nan("") : sum / static_cast<double>(values.size()));
  }
  return json;
}

Json CountJson(const MatchCount& count) {
  return {{"matches", count.MatchesPerPair()},
          {"correct", count.pairs == 0 ? 0 : static_cast<double>(count.correct) / static_cast<double>(count.pairs)},
          {"precision", NumberOrNull(count.Precision())}};
}

Json MatchingJson(const std::vector<MatchingRow>& rows) {
  Json json = Json::array();
  for (const MatchingRow& row : rows) {
    Json line = {{"set", row.set}, {"pairs", row.counts.empty() ? 0 : row.counts.front().second.pairs}};
    for (const auto& [name, count] : row.counts) line[name] = CountJson(count);
    if (!row.by_light.empty()) line["by_light"] = Json::array();
    for (const auto& [light, counts] : row.by_light) {
      Json of_light = {{"change", light}};
      for (size_t f = 0; f < counts.size(); ++f) of_light[row.counts[f].first] = CountJson(counts[f]);
      line["by_light"].push_back(std::move(of_light));
    }
    json.push_back(std::move(line));
  }
  return json;
}

Json SharesJson(const std::map<std::string, FoundShare>& shares) {
  Json json = Json::object();
  for (const auto& [name, share] : shares) {
    json[name] = {{"mean", NumberOrNull(share.mean.value())},
                  {"lowest", share.lowest},
                  {"lowest_picture", share.starved},
                  {"under_70_percent", share.under_70},
                  {"under_70_percent_where_original_is_not", share.under_70_alone}};
  }
  return json;
}

Json SetJson(const FeaturesReport& report) {
  return {{"set", report.set},
          {"pictures", report.pictures},
          {"corners", MeansJson(report.corners)},
          {"brightness", LightJson(report.light)},
          {"found", SharesJson(report.shares)},
          {"time", TimesJson(report.times_ms)},
          {"time_ten", TimesJson(report.ten_times_ms)},
          {"dispersion", DispersionJson(report.dispersions)},
          {"dispersion_ten", DispersionJson(report.ten_dispersions)},
          {"matching", MatchingJson(report.matching)}};
}

}  // namespace

std::string FeaturesJson(const std::vector<FeaturesReport>& reports) {
  Values times_ms, dispersions;
  std::vector<MatchingRow> matching;
  Json sets = Json::array();
  for (const FeaturesReport& report : reports) {
    Merge(report.times_ms, times_ms);
    Merge(report.dispersions, dispersions);
    matching.insert(matching.end(), report.matching.begin(), report.matching.end());
    sets.push_back(SetJson(report));
  }
  const Json json = {{"brightness", LightJson(MergedLight(reports))},
                     {"time", TimesJson(times_ms)},
                     {"dispersion", DispersionJson(dispersions)},
                     {"matching", MatchingJson(matching)},
                     {"sets", std::move(sets)}};
  return json.dump(2) + "\n";
}

}  // namespace yorb

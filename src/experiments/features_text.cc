// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/stats.h"
#include "core/text.h"
#include "experiments/features.h"
#include "experiments/text_table.h"

namespace yorb {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string Percent(double fraction) {
  if (!std::isfinite(fraction)) return "-";
  const std::string text = FormatFixed(100 * fraction, 1);
  return (fraction > 0 ? "+" : "") + text + " %";
}

template <typename Values>
std::string ChangeOf(const Values& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? "-" : Percent(found->second.value());
}

std::string MeanOf(const std::map<std::string, Mean>& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? "-" : NumberCell(found->second.value(), 0);
}

std::string CountsText(const FeaturesReport& report) {
  using namespace front_end;
  Rows corners{{"corners of the first threshold, all levels", "original (40)", "improved", "cv::FAST (20)"}};
  corners.push_back({"a picture as it is", MeanOf(report.corners, kOriginal), MeanOf(report.corners, kImproved),
                     MeanOf(report.corners, kCvFast)});
  Rows whole{{"what the whole extractor gives", "original 40/30", "original 20/7", "improved", "cv::ORB"}};
  for (const LightRow& row : report.light) {
    corners.push_back({row.change, ChangeOf(row.corners, kOriginal), ChangeOf(row.corners, kImproved),
                       ChangeOf(row.corners, kCvFast)});
    whole.push_back({row.change, ChangeOf(row.features, kOriginalPaper), ChangeOf(row.features, kOriginal),
                     ChangeOf(row.features, kImproved), ChangeOf(row.features, kCvOrb)});
  }
  Rows found{{"share of the wanted points", "mean", "lowest", "under 70 %", "where original 20/7 is not"}};
  for (const auto& [name, share] : report.shares) {
    found.push_back({name, FormatFixed(100 * share.mean.value(), 1) + " %", FormatFixed(100 * share.lowest, 1) + " %",
                     std::to_string(share.under_70), std::to_string(share.under_70_alone)});
  }
  return "Table 3, change of counts under other light, mean over the pictures\n" + TextTable(corners, 1) +
         TextTable(whole, 1) + TextTable(found, 1);
}

double MeanValue(const std::vector<double>& values) {
  return values.empty() ? std::nan("") : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

void AddSpreadRows(const std::string& what, const std::map<std::string, std::vector<double>>& dispersions,
                   const std::map<std::string, std::vector<double>>& times_ms, Rows& table) {
  using namespace front_end;
  std::vector<std::string> spread{"dispersion, " + what}, times{"ms a frame, " + what};
  for (const std::string& name : {kOriginalPath, kOriginal, kOriginalPaper, kImproved, kCvOrb}) {
    const auto d = dispersions.find(name), t = times_ms.find(name);
    spread.push_back(d == dispersions.end() ? "-" : NumberCell(MeanValue(d->second), 1));
    times.push_back(t == times_ms.end() ? "-" : NumberCell(Quantile(t->second, 0.5), 2));
  }
  table.push_back(spread);
  table.push_back(times);
}

std::string SpreadText(const FeaturesReport& report) {
  Rows table{{"", "ORB-SLAM2's way", "original 20/7", "original 40/30", "improved", "cv::ORB"}};
  AddSpreadRows("ten in a row", report.ten_dispersions, report.ten_times_ms, table);
  AddSpreadRows("all", report.dispersions, report.times_ms, table);
  return "Table 4, dispersion (mean) and processor time (median, one thread)\n" + TextTable(table, 1);
}

std::string CountText(const MatchCount& count) {
  return NumberCell(count.MatchesPerPair(), 1) + " at " +
         (count.matches > 0 ? FormatFixed(100 * count.Precision(), 2) + " %" : "-");
}

std::string MatchingText(const FeaturesReport& report) {
  std::string text;
  for (const MatchingRow& row : report.matching) {
    std::vector<std::string> head{row.set}, sum{"all"};
    for (const auto& [name, count] : row.counts) {
      head.push_back(name);
      sum.push_back(CountText(count));
    }
    Rows table{head};
    for (const auto& [light, counts] : row.by_light) {
      std::vector<std::string> line{light};
      for (const MatchCount& count : counts) line.push_back(CountText(count));
      table.push_back(line);
    }
    table.push_back(sum);
    text += TextTable(table, 1);
  }
  return "Table 5, matches a pair that are each other's nearest, and their precision\n" + text;
}

}  // namespace

std::string FeaturesText(const std::vector<FeaturesReport>& reports) {
  std::string text;
  for (const FeaturesReport& report : reports) {
    text += (text.empty() ? "" : "\n") + report.set + ", " + std::to_string(report.pictures) + " pictures\n\n" +
            CountsText(report) + "\n" + SpreadText(report) + "\n" + MatchingText(report);
  }
  return text;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/dynamic_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/bar_chart.h"
#include "experiments/dynamic_published.h"
#include "experiments/dynamic_text.h"
#include "experiments/text_table.h"

namespace yorb {
namespace {

DynamicRun Ran(const std::string& sequence, const std::string& way, int64_t seed, double rmse) {
  DynamicRun run;
  run.sequence = sequence;
  run.way = way;
  run.seed = seed;
  run.num_frames = 100;
  run.coverage = 1;
  run.evaluation.emplace();
  run.evaluation->ate.summary.rmse = rmse;
  run.evaluation->ate.summary.mean = 0.9 * rmse;
  run.evaluation->ate.summary.std = 0.5 * rmse;
  run.stage_ms["frame_total"] = {10, 20, 30 * static_cast<double>(seed)};
  return run;
}

DynamicReport Walking() {
  DynamicReport report;
  report.runs = {Ran("fr3_walking_xyz", "original", 1, 0.8),
                 Ran("fr3_walking_xyz", "original", 2, 0.4),
                 Ran("fr3_walking_xyz", "full", 1, 0.02),
                 Ran("fr3_walking_xyz", "full", 2, 0.04),
                 Ran("mine", "original", 1, 0.1),
                 Ran("mine", "full", 1, 0.2)};
  return report;
}

TEST(DynamicRows, AverageRunsAndCompareThemWithTheOriginal) {
  const DynamicReport report = Walking();
  const std::vector<DynamicRow> rows = DynamicRows(report);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_DOUBLE_EQ(rows[0].ate_m.rmse, 0.6);
  EXPECT_DOUBLE_EQ(rows[0].ate_spread_m, 0.2);
  EXPECT_DOUBLE_EQ(rows[1].ate_m.rmse, 0.03);
  EXPECT_NEAR(rows[1].reduction_share.rmse, 0.95, 1e-12);
  EXPECT_NEAR(rows[1].reduction_share.mean, 0.95, 1e-12);
  EXPECT_NEAR(rows[3].reduction_share.std, -1, 1e-12);
  EXPECT_DOUBLE_EQ(rows[1].stage_ms.at("frame_total"), 20);
  const std::vector<AverageReduction> averages = AverageReductions(rows);
  ASSERT_EQ(averages.size(), 1u);
  EXPECT_EQ(averages[0].num_sequences, 2u);
  EXPECT_NEAR(averages[0].reduction_share.rmse, (0.95 - 1) / 2, 1e-12);
}

TEST(DynamicRows, ARunWithoutErrorMakesTheMeanUnknown) {
  DynamicReport report = Walking();
  report.runs[2].evaluation.reset();
  const std::vector<DynamicRow> rows = DynamicRows(report);
  EXPECT_TRUE(std::isnan(rows[1].ate_m.rmse));
  EXPECT_TRUE(std::isnan(rows[1].reduction_share.rmse));
  EXPECT_EQ(AverageReductions(rows)[0].num_sequences, 1u);
  EXPECT_TRUE(nlohmann::json::parse(DynamicJson(report))["rows"][1]["ate_m"]["rmse"].is_null());
}

TEST(DynamicText, PutsPublishedFiguresBesideOursAndMarksThem) {
  const std::string text = DynamicText(Walking());
  EXPECT_THAT(text, testing::ContainsRegex("fr3_walking_xyz +full +0.0300 +measured here"));
  EXPECT_THAT(text, testing::ContainsRegex("fr3_walking_xyz +ORB-SLAM2 +0.7210 +published"));
  EXPECT_THAT(text, testing::Not(testing::ContainsRegex("mine +ORB-SLAM2")));
  EXPECT_THAT(text, testing::ContainsRegex("average of 2 +full"));
  const auto json = nlohmann::json::parse(DynamicJson(Walking()));
  EXPECT_EQ(json["published"]["ate_m"][0]["system"], "ORB-SLAM2");
}

TEST(DynamicText, WarnsOfErrorsOverFewFrames) {
  DynamicReport report = Walking();
  EXPECT_THAT(DynamicText(report), testing::Not(testing::HasSubstr("say little")));
  report.runs[5].coverage = 0.2;
  EXPECT_THAT(DynamicText(report), testing::HasSubstr("less than 95 % have a pose in: mine full\n"));
}

TEST(PublishedErrors, KnowTumsNamesAndNoOthers) {
  EXPECT_EQ(PublishedErrors("rgbd_dataset_freiburg3_walking_xyz").size(), 7u);
  EXPECT_EQ(PublishedErrors("fr3_sitting_static").size(), 4u);  // where a paper says nothing, there is nothing
  for (const char* other : {"fr3_walking_xyz_validation", "walking_xyz", "rgbd_dataset_freiburg1_xyz", ""}) {
    EXPECT_TRUE(PublishedErrors(other).empty()) << other;
  }
}

TEST(BarChart, DrawsABarForEveryValueThereIs) {
  BarChart chart{"Title", "m", true, {{"group", {{"small", 0.01, "0.01", "#111111", false}}}}};
  chart.groups[0].bars.push_back({"large & pale", 1, "1", "#222222", true});
  chart.groups[0].bars.push_back({"none", std::nan(""), "-", "#333333", false});
  const std::string svg = BarChartSvg(chart);
  for (const char* text : {"Title", "group", "small", "large &amp; pale", "#111111", "#222222", "none"}) {
    EXPECT_THAT(svg, testing::HasSubstr(text));
  }
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr("#333333")));
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr("nan")));
  EXPECT_THAT(BarChartSvg({}), testing::HasSubstr("<svg"));
}

TEST(TextTable, MakesColumnsAsWideAsTheyMustBe) {
  EXPECT_EQ(TextTable({{"name", "m"}, {"a", "10.5"}, {"long name"}}, 1),
            "name          m\na          10.5\nlong name\n");
  EXPECT_EQ(NumberCell(1.25, 1), "1.2");
  EXPECT_EQ(NumberCell(std::nan(""), 1), "-");
}

}  // namespace
}  // namespace yorb

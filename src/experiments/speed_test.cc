// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/speed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pictures/test_folder.h"
#include "runs/test_dataset.h"

namespace yorb {
namespace {

TEST(Speed, MeasuresEveryFrameAndOpenCvsOrbOnTheSamePictures) {
  Config config;
  config.mode = "inline";
  config.dynamics = "off";
  config.features.wanted = 300;
  const auto report = MeasureSpeed(WallDataset(8), config, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->frames, 8u);
  EXPECT_EQ(report->cv_orb.count, 16u);
  EXPECT_GT(report->Ratio(), 0);
  EXPECT_THAT(SpeedText(*report), testing::HasSubstr("cv::ORB(1000)"));
  const auto json = nlohmann::json::parse(SpeedJson(*report));
  EXPECT_EQ(json["stages"]["frame_total"]["count"], 8);
  EXPECT_DOUBLE_EQ(json["ratio"].get<double>(), report->Ratio());
}

TEST(Speed, RunsWithTheDetectorMasksAndMapThatTheConfigNames) {
  const WallDataset wall(4);
  const TestFolder folder;
  folder.Write("boxes.jsonl", "{\"timestamp\": 100, \"boxes\": []}\n");
  Config config;
  config.mode = "inline";
  config.features.wanted = 300;
  config.detections = folder.Path("boxes.jsonl");
  const auto report = MeasureSpeed(wall, config, {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_THAT(SpeedText(*report), testing::HasSubstr("\ndetect "));
  for (std::string Config::*file : {&Config::detections, &Config::masks, &Config::load_map}) {
    Config missing = config;
    missing.*file = folder.Path("nothere");
    const auto refused = MeasureSpeed(wall, missing, {});
    ASSERT_FALSE(refused.ok());
    EXPECT_THAT(refused.error().message, testing::HasSubstr("nothere"));
  }
}

TEST(Speed, SaysNullWhereNothingWasMeasured) {
  const auto json = nlohmann::json::parse(SpeedJson(SpeedReport()));
  EXPECT_TRUE(json["ratio"].is_null());
  EXPECT_TRUE(json["cv_orb"]["median_ms"].is_null());
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/light_text.h"
#include "experiments/test_room.h"

namespace yorb {
namespace {

constexpr int kFrames = 8;

class LightBench : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    room_ = new RoomDataset(kFrames);
    options_ = new LightBenchOptions();
    options_->config.features.wanted = 1000;
    options_->lights = {LightKind::kFlicker};
    options_->truth = room_->Truth();
    report_ = new Result<LightReport>(MeasureLight(*room_, *options_, {}));
  }
  static void TearDownTestSuite() {
    delete report_;
    delete options_;
    delete room_;
  }

  static RoomDataset* room_;
  static LightBenchOptions* options_;
  static Result<LightReport>* report_;
};
RoomDataset* LightBench::room_ = nullptr;
LightBenchOptions* LightBench::options_ = nullptr;
Result<LightReport>* LightBench::report_ = nullptr;

TEST_F(LightBench, RunsEveryLightWithEveryFrontEndAndSteadyFirst) {
  ASSERT_TRUE(report_->ok()) << report_->error().message;
  const auto& runs = (*report_)->runs;
  ASSERT_EQ(runs.size(), 6u);
  for (size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].light, i < 3 ? LightKind::kSteady : LightKind::kFlicker);
    EXPECT_EQ(runs[i].front_end, LightFrontEnds({})[i % 3].name);
    EXPECT_EQ(runs[i].frames.size(), static_cast<size_t>(kFrames));
    EXPECT_EQ(runs[i].ate_m.has_value(), runs[i].coverage > 0.25);
  }
  EXPECT_EQ(runs[2].coverage, 1);
  EXPECT_LT(runs[2].ate_m.value(), 0.02);
}

TEST_F(LightBench, BrightnessIsThatOfThePicturesGiven) {
  ASSERT_TRUE(report_->ok());
  const auto& runs = (*report_)->runs;
  for (size_t i = 0; i < static_cast<size_t>(kFrames); ++i) {
    const double recorded = cv::mean(room_->Load(i)->images->grey)[0];
    EXPECT_DOUBLE_EQ(runs[0].frames[i].brightness, recorded);
    EXPECT_NE(runs[3].frames[i].brightness, recorded);
    // Whatever the front end, the pictures of a seed are the same.
    EXPECT_DOUBLE_EQ(runs[3].frames[i].brightness, runs[5].frames[i].brightness);
  }
}

TEST_F(LightBench, HighThresholdsFindLess) {
  ASSERT_TRUE(report_->ok());
  const auto sum = [](const LightRun& run) {
    int features = 0;
    for (const LightFrame& frame : run.frames) features += frame.num_features;
    return features;
  };
  EXPECT_LT(sum((*report_)->runs[1]), sum((*report_)->runs[0]));
  EXPECT_LT(sum((*report_)->runs[4]), sum((*report_)->runs[5]));
}

TEST_F(LightBench, RepeatsToTheBit) {
  ASSERT_TRUE(report_->ok());
  const auto again = MeasureLight(*room_, *options_, {});
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(LightJson(*again), LightJson(**report_));
}

TEST_F(LightBench, TableJsonAndPlotSayTheSame) {
  ASSERT_TRUE(report_->ok());
  const auto json = nlohmann::json::parse(LightJson(**report_));
  EXPECT_EQ(json["frames"], kFrames);
  ASSERT_EQ(json["rows"].size(), 6u);
  EXPECT_EQ(json["rows"][5]["light"], "flicker");
  EXPECT_EQ(json["rows"][5]["front_end"], "ours");
  EXPECT_DOUBLE_EQ(json["rows"][2]["ate_ratio"].get<double>(), 1);
  EXPECT_DOUBLE_EQ(json["rows"][2]["ate_m"].get<double>(), (*report_)->runs[2].ate_m.value());
  EXPECT_LE(json["rows"][5]["features"]["min"], json["rows"][5]["features"]["mean"]);
  EXPECT_THAT(LightText(**report_), testing::HasSubstr("flicker  ours"));
  const std::string sheet = LightSheet(**report_, LightKind::kFlicker);
  for (const char* word : {"<svg", "original 40/30", "points tracked", "mean grey level"})
    EXPECT_THAT(sheet, testing::HasSubstr(word));
}

TEST_F(LightBench, WithoutTruthTheErrorIsNull) {
  LightBenchOptions options = *options_;
  options.truth.clear();
  options.lights.clear();
  options.config.max_frames = 3;
  const auto report = MeasureLight(*room_, options, {});
  ASSERT_TRUE(report.ok());
  const auto json = nlohmann::json::parse(LightJson(*report));
  EXPECT_EQ(json["frames"], 3);
  EXPECT_TRUE(json["rows"][0]["ate_m"].is_null());
  EXPECT_TRUE(json["rows"][0]["ate_ratio"].is_null());
}

TEST_F(LightBench, StopsWhenAskedAndKeepsWhatIsDone) {
  size_t num_runs = 0;
  LightBenchHooks hooks;
  hooks.should_stop = [&] { return num_runs == 1; };
  hooks.on_run = [&](const LightRun&) { ++num_runs; };
  const auto report = MeasureLight(*room_, *options_, hooks);
  ASSERT_TRUE(report.ok());
  EXPECT_TRUE(report->was_stopped);
  EXPECT_EQ(report->runs.size(), 1u);
}

}  // namespace
}  // namespace yorb

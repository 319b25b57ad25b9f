// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// From pictures to results, through the library: every mode, on a rendered room with exact truth.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/core/utility.hpp>

#include "core/log.h"
#include "core/text.h"
#include "evaluation/ate.h"
#include "map/map.h"
#include "runs/feed.h"
#include "runs/run.h"
#include "system/config_io.h"
#include "tests/synthetic_dataset.h"

namespace yorb {
namespace {

constexpr int kFrames = 40;

const SyntheticDataset& Room() {
  static const SyntheticDataset room(kFrames);
  return room;
}

Config TestConfig(const std::string& mode) {
  Config config;
  config.mode = mode;
  config.features.wanted = 500;
  return config;
}

SlamReport RunInMemory(const Config& config) {
  cv::setNumThreads(1);
  auto slam = Slam::Create(config, Room().rig());
  EXPECT_TRUE(slam.ok());
  const FeedLog fed = Feed(Room(), config, **slam, {});
  EXPECT_FALSE(fed.error) << fed.error->message;
  return (*slam)->Report();
}

double AteRmse(const Trajectory& estimate) {
  const auto pairs = AssociateStamps(StampsOf(Room().truth()), StampsOf(estimate), 1000);
  return ComputeAbsoluteError(Room().truth(), estimate, pairs, EvalAlign::kSe3).summary.rmse;
}

class EndToEnd : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Modes, EndToEnd, testing::Values("inline", "offline"));

TEST_P(EndToEnd, EveryFrameIsTrackedAndTheTrajectoryIsTrue) {
  const SlamReport report = RunInMemory(TestConfig(GetParam()));
  EXPECT_EQ(report.frames.size(), size_t{kFrames});
  EXPECT_EQ(report.trajectory.size(), size_t{kFrames});
  EXPECT_GE(report.keyframes.size(), 1u);
  EXPECT_GT(report.num_landmarks, 100u);
  EXPECT_LT(AteRmse(report.trajectory), 0.02);
}

TEST(EndToEndLive, FramesThatCameAreTrackedAndTimeGoesOn) {
  const SlamReport report = RunInMemory(TestConfig("live"));
  EXPECT_GE(report.trajectory.size(), 1u);  // a slow machine (or a sanitizer) may drop the rest
  EXPECT_LE(report.trajectory.size(), report.frames.size());
  for (size_t i = 1; i < report.trajectory.size(); ++i) {
    EXPECT_LT(report.trajectory[i - 1].timestamp, report.trajectory[i].timestamp);
  }
  if (report.trajectory.size() > 3) {
    EXPECT_LT(AteRmse(report.trajectory), 0.03);
  }
}

TEST(EndToEndInline, TwoRunsAreAlikeToTheBit) {
  const SlamReport first = RunInMemory(TestConfig("inline")), second = RunInMemory(TestConfig("inline"));
  EXPECT_EQ(TumText(first.trajectory), TumText(second.trajectory));
  EXPECT_EQ(TumText(first.keyframes), TumText(second.keyframes));
  EXPECT_EQ(first.num_landmarks, second.num_landmarks);
}

TEST(EndToEndInline, TheMapKeepsItsPromises) {
  const Config config = TestConfig("inline");
  auto slam = Slam::Create(config, Room().rig());
  ASSERT_TRUE(slam.ok());
  FeedHooks hooks;
  hooks.after_frame = [&](const FeedLog&) { (*slam)->Snapshot()->Check(); };
  Feed(Room(), config, **slam, hooks);
}

TEST(EndToEndInline, TheWrittenConfigRepeatsTheRunToTheBit) {
  const std::string folder = testing::TempDir() + "end_to_end_repeat";
  std::filesystem::remove_all(folder);
  RunOptions options;
  options.config = TestConfig("inline");
  options.config.features.alpha = 0.7000000000000001;
  options.config.max_frames = 20;
  options.out = folder + "/first";
  ASSERT_TRUE(RunSequence(Room(), options, {}).ok());
  const auto file = ReadConfigFile(options.out + "/config.yaml");
  ASSERT_TRUE(file.ok()) << file.error().message;
  const auto config = WithSettings(Config(), file->settings);
  ASSERT_TRUE(config.ok()) << config.error().message;
  const auto rig = ParseCameraFile(file->camera_text, "config.yaml");
  ASSERT_TRUE(rig.ok()) << rig.error().message;
  EXPECT_EQ(CameraFileText(*rig), CameraFileText(Room().rig()));
  options.config = *config;
  options.out = folder + "/second";
  ASSERT_TRUE(RunSequence(Room(), options, {}).ok());
  for (const char* name : {"trajectory.txt", "keyframes.txt", "config.yaml"}) {
    EXPECT_EQ(*ReadWholeText(folder + "/first/" + name), *ReadWholeText(folder + "/second/" + name)) << name;
  }
  std::filesystem::remove_all(folder);
}

TEST(Slam, RefusesWhatItCannotUseAndGoesOn) {
  const Config config = TestConfig("inline");
  auto slam = Slam::Create(config, Room().rig());
  ASSERT_TRUE(slam.ok());
  const auto frame = [](size_t i) { return *Room().Load(i)->images; };
  EXPECT_TRUE((*slam)->Push(frame(0)).ok());
  EXPECT_FALSE((*slam)->Push(frame(0)).ok());  // the same moment again
  ImageSet small = frame(1);
  small.grey = small.grey(cv::Rect(0, 0, 100, 100)).clone();
  EXPECT_FALSE((*slam)->Push(small).ok());
  EXPECT_TRUE((*slam)->Push(frame(1)).ok());
  (*slam)->Finish();
  EXPECT_EQ((*slam)->Report().frames.size(), 2u);
}

TEST(DefaultConfigFile, ListsEveryKeyWithItsBuiltInValue) {
  const auto file = ReadConfigFile(std::string(YORB_SOURCE_DIR) + "/configs/default.yaml");
  ASSERT_TRUE(file.ok()) << file.error().message;
  std::vector<std::string> keys;
  for (const Setting& setting : file->settings) keys.push_back(setting.key);
  EXPECT_THAT(keys, testing::ElementsAreArray(ConfigKeys()));
  const auto config = WithSettings(Config(), file->settings);
  ASSERT_TRUE(config.ok()) << config.error().message;
  EXPECT_EQ(ConfigText(*config, ""), ConfigText(Config(), ""));
}

}  // namespace
}  // namespace yorb

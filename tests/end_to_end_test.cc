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
  EXPECT_EQ(report.trajectory().size(), size_t{kFrames});
  EXPECT_GE(report.keyframes().size(), 1u);
  EXPECT_GT(report.num_landmarks, 100u);
  EXPECT_LT(AteRmse(report.trajectory()), 0.02);
}

TEST(EndToEndLive, FramesThatCameAreTrackedAndTimeGoesOn) {
  const SlamReport report = RunInMemory(TestConfig("live"));
  EXPECT_GE(report.trajectory().size(), 1u);  // a slow machine (or a sanitizer) may drop the rest
  EXPECT_LE(report.trajectory().size(), report.frames.size());
  for (size_t i = 1; i < report.trajectory().size(); ++i) {
    EXPECT_LT(report.trajectory()[i - 1].timestamp, report.trajectory()[i].timestamp);
  }
  if (report.trajectory().size() > 3) {
    EXPECT_LT(AteRmse(report.trajectory()), 0.03);
  }
}

TEST(EndToEndInline, TwoRunsAreAlikeToTheBit) {
  const SlamReport first = RunInMemory(TestConfig("inline")), second = RunInMemory(TestConfig("inline"));
  EXPECT_EQ(TumText(first.trajectory()), TumText(second.trajectory()));
  EXPECT_EQ(TumText(first.keyframes()), TumText(second.keyframes()));
  EXPECT_EQ(first.num_landmarks, second.num_landmarks);
}

TEST(EndToEndOffline, IsAlikeToInlineToTheBitWhereNoLoopIsClosed) {
  // Threads change when something is done, not what: each keyframe is adjusted before the next frame is measured.
  const SlamReport inlined = RunInMemory(TestConfig("inline")), offline = RunInMemory(TestConfig("offline"));
  EXPECT_EQ(TumText(inlined.trajectory()), TumText(offline.trajectory()));
  EXPECT_EQ(TumText(inlined.keyframes()), TumText(offline.keyframes()));
  EXPECT_EQ(inlined.num_landmarks, offline.num_landmarks);
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

/// Sees somebody in the left third of each picture; fails when it is asked once too often.
class ThirdDetector : public Detector {
 public:
  explicit ThirdDetector(int num_good) : num_good_(num_good) {}
  Result<Detections> Detect(const ImageSet& images) override {
    if (num_good_-- == 0) return BadInput("the detector is worn out");
    const double width = images.grey.cols, height = images.grey.rows;
    return Detections{true, {{"person", 0.9, 0, 0, width / 3, height}}};
  }

 private:
  int num_good_;
};

class EndToEndDynamics : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Modes, EndToEndDynamics, testing::Values("inline", "offline", "live"));

TEST_P(EndToEndDynamics, PointsInBoxesGoAndTheRestIsEnough) {
  cv::setNumThreads(1);
  Config config = TestConfig(GetParam());
  config.dynamics = "paper";
  SlamParts parts;
  parts.detector = std::make_unique<ThirdDetector>(kFrames);
  size_t num_watched = 0;
  parts.watch = [&](const Watched& watched) {
    ++num_watched;
    EXPECT_EQ(watched.points.size(), watched.verdicts.size());
    for (size_t i = 0; i < watched.points.size() && !watched.areas.boxes().empty(); ++i) {
      const bool is_left = static_cast<double>(watched.points[i].x) + 0.5 < watched.images.grey.cols / 3.0;
      EXPECT_EQ(watched.verdicts[i] == Verdict::kDynamic, is_left);
    }
  };
  auto slam = Slam::Create(config, Room().rig(), std::move(parts));
  ASSERT_TRUE(slam.ok());
  const FeedLog fed = Feed(Room(), config, **slam, {});
  EXPECT_FALSE(fed.error) << fed.error->message;
  const SlamReport report = (*slam)->Report();
  EXPECT_EQ(num_watched, report.frames.size());
  ASSERT_GE(report.trajectory().size(), 1u);
  if (std::string(GetParam()) == "live") return;  // a slow machine drops frames and boxes
  EXPECT_EQ(report.trajectory().size(), size_t{kFrames});
  EXPECT_LT(AteRmse(report.trajectory()), 0.02);
  for (const FrameRecord& frame : report.frames) {
    EXPECT_EQ(frame.num_boxes, 1);
    EXPECT_GT(frame.num_removed, 0);
    EXPECT_LE(frame.num_static, 500);
    EXPECT_GT(frame.num_static, 250);
  }
}

TEST_P(EndToEndDynamics, ADetectorThatFailsEndsTheRunWithWhatThereIs) {
  Config config = TestConfig(GetParam());
  config.dynamics = "full";
  SlamParts parts;
  parts.detector = std::make_unique<ThirdDetector>(0);
  auto slam = Slam::Create(config, Room().rig(), std::move(parts));
  ASSERT_TRUE(slam.ok());
  const FeedLog fed = Feed(Room(), config, **slam, {});
  ASSERT_TRUE(fed.error);
  EXPECT_THAT(fed.error->message, testing::HasSubstr("worn out"));
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

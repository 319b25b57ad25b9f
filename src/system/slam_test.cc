// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "system/slam.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/random.h"
#include "system/pipeline.h"

namespace yorb {
namespace {

using testing::HasSubstr;

constexpr int kWidth = 160, kHeight = 120;

Rig SmallRig() {
  Rig rig;
  rig.camera.width = kWidth;
  rig.camera.height = kHeight;
  rig.camera.fx = rig.camera.fy = 150;
  rig.camera.cx = kWidth / 2.0;
  rig.camera.cy = kHeight / 2.0;
  rig.baseline_px = 12;
  rig.depth_factor = 1000;
  return rig;
}

ImageSet Picture(int index) {
  ImageSet images;
  images.timestamp = {index * int64_t{33'000'000}};
  images.grey = cv::Mat(kHeight, kWidth, CV_8UC1);
  Random random(5);
  for (int i = 0; i < kWidth * kHeight; ++i) images.grey.data[i] = static_cast<uchar>(random.Below(256));
  images.depth = {cv::Mat(kHeight, kWidth, CV_16UC1, cv::Scalar(2000)), 0.001};
  return images;
}

std::string Refusal(const ImageSet& images) {
  auto slam = Slam::Create(Config(), SmallRig());
  if (!slam) return slam.error().message;
  const auto pushed = (*slam)->Push(images);
  return pushed ? "" : pushed.error().message;
}

TEST(Slam, RefusesWhatIsNoImageSet) {
  EXPECT_EQ(Refusal(Picture(0)), "");
  ImageSet coloured = Picture(0), bytes = Picture(0), small = Picture(0), without = Picture(0);
  coloured.grey = cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar(0, 0, 0));
  bytes.depth.pixels = cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(2));
  small.depth.pixels = cv::Mat(kHeight / 2, kWidth / 2, CV_16UC1, cv::Scalar(2000));
  without.depth = {};
  EXPECT_THAT(Refusal(coloured), HasSubstr("not 8-bit grey"));
  EXPECT_THAT(Refusal(bytes), HasSubstr("neither 16-bit nor float"));
  EXPECT_THAT(Refusal(small), HasSubstr("not of the picture's size"));
  EXPECT_EQ(Refusal(without), "");
}

TEST(Slam, RefusesAConfigurationThatCannotWork) {
  Config config;
  config.features.wanted = -1;
  const auto slam = Slam::Create(config, SmallRig());
  ASSERT_FALSE(slam.ok());
  EXPECT_THAT(slam.error().message, HasSubstr("features.wanted"));
}

class Pipelines : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Threaded, Pipelines, testing::Values("offline", "live"));

TEST_P(Pipelines, AStageThatThrowsClosesAllStreamsAndSaysWhy) {
  Config config;
  config.features.wanted = -1;  // of which extraction makes a length that no vector has
  config.mode = GetParam();
  const bool is_live = config.mode == "live";
  Pipeline pipeline(config, SmallRig(), {});
  bool is_open = true;
  for (int i = 0; i < 1000 && is_open; ++i) {
    is_open = pipeline.Push(Picture(i)) || is_live;
    if (is_live && !pipeline.Fault()) is_open = false;
  }
  pipeline.Finish();
  ASSERT_FALSE(pipeline.Fault().ok());
  EXPECT_EQ(pipeline.Fault().error().kind, Error::Kind::kFailure);
  EXPECT_EQ(pipeline.num_frames_done(), 0u);
}

TEST_P(Pipelines, AreFineWhenAllIsWell) {
  Config config;
  config.mode = GetParam();
  Pipeline pipeline(config, SmallRig(), {});
  EXPECT_TRUE(pipeline.Push(Picture(0)));
  pipeline.Finish();
  EXPECT_TRUE(pipeline.Fault().ok());
  EXPECT_EQ(pipeline.num_frames_done(), 1u);
}

/// Sees nobody, and counts how often it looked.
class CountingDetector : public Detector {
 public:
  explicit CountingDetector(int& num_looks) : num_looks_(num_looks) {}
  Result<Detections> Detect(const ImageSet&) override {
    ++num_looks_;
    return Detections{true, {}};
  }

 private:
  int& num_looks_;
};

/// How often a detector looks at `num_pictures` pictures of 30 Hz.
int LooksAt(int num_pictures, const Config& config) {
  int num_looks = 0;
  SlamParts parts;
  parts.detector = std::make_unique<CountingDetector>(num_looks);
  Pipeline pipeline(config, SmallRig(), std::move(parts));
  for (int i = 0; i < num_pictures; ++i) EXPECT_TRUE(pipeline.Push(Picture(i)));
  pipeline.Finish();
  EXPECT_EQ(pipeline.num_frames_done(), static_cast<size_t>(num_pictures));
  return num_looks;
}

/// Takes its time to see one person.
class SlowDetector : public Detector {
 public:
  Result<Detections> Detect(const ImageSet&) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return Detections{true, {{"person", 0.9, 20, 20, 80, 100}}};
  }
};

TEST(LivePipeline, AFrameWaitsForItsBoxesWhileNoPictureWaitsForIt) {
  Config config;
  config.mode = "live";
  SlamParts parts;
  parts.detector = std::make_unique<SlowDetector>();
  Pipeline pipeline(config, SmallRig(), std::move(parts));
  constexpr size_t kPictures = 4;
  for (size_t i = 0; i < kPictures; ++i) {
    EXPECT_TRUE(pipeline.Push(Picture(static_cast<int>(12 * i))));  // 0.4 s later, when all is done
    while (pipeline.num_frames_done() <= i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  pipeline.Finish();
  const std::vector<FrameRecord> frames = pipeline.Report().frames;
  ASSERT_EQ(frames.size(), kPictures);
  for (const FrameRecord& frame : frames) EXPECT_EQ(frame.num_boxes - frame.num_bridged, 1) << frame.id.value();
}

TEST(Slam, TheNetworkIsSparedOnlyWhereItsBoxesAreFollowed) {
  for (const char* mode : {"inline", "offline"}) {
    Config config;
    config.mode = mode;
    config.dynamics = "full";
    config.detection.interval_s = 0.08;
    EXPECT_EQ(LooksAt(9, config), 3) << mode;
    config.detection.interval_s = 0;
    EXPECT_EQ(LooksAt(9, config), 9) << mode;
    config.detection.interval_s = 0.08;
    config.detections = "boxes.txt";
    EXPECT_EQ(LooksAt(9, config), 9) << mode << ": a file costs nothing";
    config.detections.clear();
    config.dynamics = "paper";
    EXPECT_EQ(LooksAt(9, config), 9) << mode << ": the rules ask for the boxes of this very picture";
  }
}

}  // namespace
}  // namespace yorb

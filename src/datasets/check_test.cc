// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "datasets/depth_watch.h"
#include "datasets/test_recording.h"

namespace yorb {
namespace {

using ::testing::HasSubstr;

bool Finds(const SequenceCheck& check, Finding::Level level, const std::string& topic) {
  return std::any_of(check.findings.begin(), check.findings.end(),
                     [&](const Finding& f) { return f.level == level && f.topic == topic; });
}

/// All findings of one kind, a line each.
std::string TextsOf(const SequenceCheck& check, Finding::Level level, const std::string& topic) {
  std::string texts;
  for (const Finding& finding : check.findings) {
    if (finding.level == level && finding.topic == topic) texts += finding.text + "\n";
  }
  return texts;
}

class Check : public ::testing::Test {
 protected:
  void SetUp() override {
    WriteRecording(folder_, "seq", 6);
    folder_.Write("seq/groundtruth.txt",
                  "# truth\n1000.0 0 0 0 0 0 0 1\n1000.034 0 0 0 0 0 0 1\n1000.066 0 0 0 0 0 0 1\n");
  }
  SequenceCheck Run(const std::string& camera = "") { return CheckSequence(folder_.Path("seq"), camera); }

  TestFolder folder_;
};

TEST_F(Check, AGoodRecordingIsUsableInNumbers) {
  const SequenceCheck check = Run();
  EXPECT_TRUE(check.is_usable()) << CheckText(check);
  EXPECT_EQ(check.colour.count, 6u);
  EXPECT_NEAR(*check.colour.rate_hz, 30, 0.01);
  EXPECT_EQ(*check.num_pairs, 6u);
  EXPECT_NEAR(*check.median_pair_distance_s, 0.005, 1e-6);
  EXPECT_EQ(*check.width, 64);
  EXPECT_NEAR(*check.depth_median_m, 1.5, 1e-6);
  EXPECT_EQ(*check.depth_hole_share, 0);
  EXPECT_NEAR(*check.truth_share, 0.5, 1e-9);
  const auto json = nlohmann::json::parse(CheckJson(check));
  EXPECT_EQ(json["usable"], true);
  EXPECT_EQ(json["pairs"], 6);
  EXPECT_NEAR(json["depth_range_m"]["median"].get<double>(), 1.5, 1e-6);
}

TEST_F(Check, SaysSeveralThingsAtOnce) {
  std::filesystem::remove(folder_.Path("seq/camera.yaml"));
  std::filesystem::remove(folder_.Path("seq/rgb/5.png"));
  folder_.Write("seq/rgb/2.png", "");
  const SequenceCheck check = Run();
  EXPECT_FALSE(check.is_usable());
  EXPECT_TRUE(Finds(check, Finding::Level::kError, "files"));
  EXPECT_TRUE(Finds(check, Finding::Level::kError, "camera"));
  EXPECT_TRUE(Finds(check, Finding::Level::kWarning, "pictures"));
  EXPECT_THAT(CheckText(check), HasSubstr("not usable"));
  const auto json = nlohmann::json::parse(CheckJson(check));
  EXPECT_TRUE(json["camera"].is_null());
  EXPECT_TRUE(json["depth_range_m"]["median"].is_null());
}

TEST_F(Check, AbsurdDepthFactorsAndSizesAreSeen) {
  std::string camera = kTestCamera;
  folder_.Write("seq/camera.yaml", camera.replace(camera.find("1000"), 4, "1"));
  EXPECT_TRUE(Finds(Run(), Finding::Level::kWarning, "depth"));
  folder_.Write("seq/camera.yaml", "fx: 50\nfy: 50\ncx: 31.5\ncy: 23.5\nwidth: 64\nheight: 64\ndepth_factor: 1000\n");
  EXPECT_TRUE(Finds(Run(), Finding::Level::kError, "camera"));
  folder_.WritePicture("seq/depth/3.png", TestColour(1));
  EXPECT_TRUE(Finds(Run(), Finding::Level::kError, "depth"));
}

TEST_F(Check, TellsOfAnotherCameraThanTheFoldersNameSaysWhereARunDoes) {
  std::filesystem::rename(folder_.Path("seq"), folder_.Path("rgbd_dataset_freiburg1_seq"));
  const std::string folder = folder_.Path("rgbd_dataset_freiburg1_seq");
  EXPECT_THAT(TextsOf(CheckSequence(folder, ""), Finding::Level::kWarning, "camera"),
              HasSubstr("stands for camera tum_fr1"));
  const auto own = CheckSequence(folder, folder_.Write("own.yaml", "fx: 517\nfy: 516\ncx: 318\ncy: 255\nname: own\n"));
  EXPECT_EQ(TextsOf(own, Finding::Level::kWarning, "camera").find("stands for"), std::string::npos)
      << "a calibration of one's own for the same camera";
}

TEST_F(Check, AnInvertedDepthFactorIsToldWithTheRightOne) {
  std::string camera = kTestCamera;
  folder_.Write("seq/camera.yaml", camera.replace(camera.find("1000"), 4, "0.001"));
  EXPECT_THAT(TextsOf(Run(), Finding::Level::kWarning, "depth"), HasSubstr("units per metre: 1000, not"));
}

TEST_F(Check, PicturesThatCannotBeReadAreCountedInOneLine) {
  for (const char* name : {"seq/rgb/1.png", "seq/rgb/2.png", "seq/depth/3.png", "seq/depth/4.png"}) {
    folder_.Write(name, "");
  }
  SequenceCheck check = Run();
  EXPECT_TRUE(check.is_usable()) << CheckText(check);
  for (const char* topic : {"pictures", "depth"}) {
    const std::string texts = TextsOf(check, Finding::Level::kWarning, topic);
    EXPECT_EQ(std::count(texts.begin(), texts.end(), '\n'), 1) << texts;
    EXPECT_THAT(texts, HasSubstr("2 of the ")) << topic;
  }
  for (int k = 0; k < 6; ++k) folder_.Write("seq/depth/" + std::to_string(k) + ".png", "");
  check = Run();
  EXPECT_FALSE(check.is_usable()) << "no map could begin";
  EXPECT_THAT(TextsOf(check, Finding::Level::kError, "depth"), HasSubstr("none of the depth pictures"));
  EXPECT_FALSE(Finds(check, Finding::Level::kWarning, "depth"));
}

TEST_F(Check, DepthOfAnotherMomentIsNoPair) {
  folder_.Write("seq/associations.txt",
                "1000.0 rgb/0.png 1000.02 depth/0.png\n1000.1 rgb/1.png 2000 depth/1.png\n"
                "1000.2 rgb/2.png 2000.1 depth/2.png\n");
  const SequenceCheck check = Run();
  EXPECT_EQ(*check.num_pairs, 1u);
  EXPECT_GT(*check.median_pair_distance_s, 900);
  EXPECT_THAT(TextsOf(check, Finding::Level::kWarning, "pairs"), HasSubstr("2 pairs of the list are farther apart"));
}

TEST_F(Check, StampsThatMayBeFrameNumbersAreAFinding) {
  std::string rgb, depth;
  for (int k = 0; k < 6; ++k) {
    const std::string number = std::to_string(k);
    rgb += number + " rgb/" + number + ".png\n";
    depth += number + " depth/" + number + ".png\n";
  }
  EXPECT_FALSE(Finds(Run(), Finding::Level::kWarning, "stamps"));
  folder_.Write("seq/rgb.txt", rgb);
  folder_.Write("seq/depth.txt", depth);
  EXPECT_THAT(TextsOf(Run(), Finding::Level::kWarning, "stamps"), HasSubstr("frame numbers"));
}

TEST_F(Check, ReadsWhatIsThereOfABrokenFolder) {
  folder_.Write("seq/rgb.txt", "1000.0 rgb/0.png\n1000.0 rgb/1.png\n");
  EXPECT_TRUE(Finds(Run(), Finding::Level::kError, "lists"));
  EXPECT_FALSE(CheckSequence(folder_.Path("gone"), "").is_usable());
  EXPECT_TRUE(nlohmann::json::accept(CheckJson(CheckSequence("g\xff\"one", ""))));
}

LoadedFrame FrameWithDepth(double share, double median_m) {
  LoadedFrame frame;
  frame.images = ImageSet{};
  frame.depth = {true, false, share, median_m};
  return frame;
}

class Watch : public ::testing::Test {
 protected:
  std::string Warnings(double share, double median_m, bool needs_depth = true) {
    ::testing::internal::CaptureStderr();
    Rig rig;
    rig.name = "cam";
    DepthWatch watch(rig);
    for (int i = 0; i < 20; ++i) watch.Add(FrameWithDepth(share, median_m));
    watch.Conclude(needs_depth);
    return ::testing::internal::GetCapturedStderr();
  }
};

TEST_F(Watch, WarnsOnceOfWhatCannotBeMeant) {
  EXPECT_EQ(Warnings(0.8, 1.5), "");
  EXPECT_THAT(Warnings(0.0, 0.0), HasSubstr("no usable depth"));
  EXPECT_EQ(Warnings(0.0, 0.0, false), "") << "of a camera that is only located";
  for (const double median_m : {0.005, 7500.0}) {
    const std::string said = Warnings(0.8, median_m);
    EXPECT_THAT(said, HasSubstr("depth factor"));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
  }
}

TEST_F(Watch, AnInvertedFactorIsNoWantOfDepth) {
  constexpr double kInverse = 0.0002;
  Rig rig;
  rig.depth_factor = kInverse;
  LoadedFrame frame;
  frame.images = ImageSet{};
  frame.depth = GlanceAt({cv::Mat(48, 64, CV_16UC1, cv::Scalar(7500)), 1 / kInverse});
  ::testing::internal::CaptureStderr();
  DepthWatch watch(rig);
  watch.Add(frame);
  watch.Conclude();
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("depth_factor is units per metre: 5000, not"));
  EXPECT_THAT(said, ::testing::Not(HasSubstr("no usable depth")));
  EXPECT_FALSE(watch.has_seen_any());
  EXPECT_THAT(DepthWatch::FactorComplaint(7500, false, 1, "cam"), HasSubstr("1000 where"));
}

TEST(GlanceAt, SeesShareAndMedian) {
  cv::Mat pixels(48, 64, CV_16UC1, cv::Scalar(2000));
  pixels.colRange(0, 32).setTo(0);
  const DepthGlance glance = GlanceAt({pixels, 1e-3});
  EXPECT_NEAR(glance.measured_share, 0.5, 0.05);
  EXPECT_NEAR(glance.median_m, 2, 1e-6);
  pixels.setTo(65535);
  EXPECT_EQ(GlanceAt({pixels, 1e6}).measured_share, 0) << "not measured, whatever the factor";
  EXPECT_FALSE(GlanceAt({}).has_picture);
}

}  // namespace
}  // namespace yorb

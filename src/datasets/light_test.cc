// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "datasets/light_dataset.h"

namespace yorb {
namespace {

/// Every grey level up to the middle, many times over: dark enough that x2 saturates nothing.
cv::Mat Ramps(int channels = 3) {
  cv::Mat picture(96, 128, CV_8UC(channels));
  for (int y = 0; y < picture.rows; ++y) {
    for (int i = 0; i < picture.cols * channels; ++i)
      picture.ptr(y)[i] = static_cast<uint8_t>((i / channels + 37 * y) % 128);
  }
  return picture;
}

double MeanOf(const cv::Mat& picture) { return cv::mean(picture.reshape(1))[0]; }

bool AreEqual(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

const std::vector<LightKind> kUniform = {LightKind::kRamp, LightKind::kFlicker, LightKind::kSwitch, LightKind::kDim};

TEST(Light, EveryNameIsReadBack) {
  for (const std::string& name : LightNames()) EXPECT_EQ(ToString(ParseLight(name).value()), name);
  EXPECT_FALSE(ParseLight("strobe"));
}

TEST(Light, NoChangeAndNoNoiseIsThePictureItself) {
  const cv::Mat picture = Ramps();
  EXPECT_EQ(InLight({LightKind::kSteady, 0, 1}, 3, 0.5, picture).data, picture.data);
  // The light of `switch` is on in the first four seconds: through the sensor and back, nothing changes.
  const cv::Mat through = InLight({LightKind::kSwitch, 0, 1}, 3, 0.5, picture);
  EXPECT_NE(through.data, picture.data);
  EXPECT_LE(cv::norm(through, picture, cv::NORM_INF), 1);
}

TEST(Light, BrightnessFollowsTheCurveWithoutNoise) {
  const cv::Mat picture = Ramps();
  for (const LightKind kind : kUniform) {
    for (size_t frame = 0; frame < 300; frame += 7) {
      const MovingLight light{kind, 0, 5};
      const double seconds = static_cast<double>(frame) / 30, factor = LightFactor(light, frame, seconds);
      const double expected = MeanOf(picture) * std::pow(factor, 1 / 2.2);
      EXPECT_NEAR(MeanOf(InLight(light, frame, seconds, picture)), expected, 0.4) << ToString(kind) << frame;
    }
  }
}

TEST(Light, FactorsStayInTheirBoundsAndReachThem) {
  const auto range_of = [](LightKind kind) {
    std::pair<double, double> range(1e9, 0);
    for (size_t frame = 0; frame < 900; ++frame) {
      const double factor = LightFactor({kind, 1, 2}, frame, static_cast<double>(frame) / 30);
      range = {std::min(range.first, factor), std::max(range.second, factor)};
    }
    return range;
  };
  const auto expect_range = [&](LightKind kind, double low, double high, double tolerance) {
    const auto [least, most] = range_of(kind);
    EXPECT_NEAR(least, low, low * tolerance) << ToString(kind);
    EXPECT_NEAR(most, high, high * tolerance) << ToString(kind);
    EXPECT_GE(least, low * (1 - 1e-9));
    EXPECT_LE(most, high * (1 + 1e-9));
  };
  expect_range(LightKind::kRamp, 0.03, 2, 1e-3);
  expect_range(LightKind::kFlicker, 0.1, 2, 0.02);
  expect_range(LightKind::kSwitch, 0.02, 1, 1e-9);
  expect_range(LightKind::kDim, 0.02, 0.02, 1e-9);
  expect_range(LightKind::kShade, 1, 1, 1e-9);
}

TEST(Light, TheSwitchIsAtOnceAndEveryFourSeconds) {
  const MovingLight light{LightKind::kSwitch, 1, 1};
  EXPECT_EQ(LightFactor(light, 0, 3.999), 1);
  EXPECT_EQ(LightFactor(light, 0, 4.001), 0.02);
  EXPECT_EQ(LightFactor(light, 0, 7.999), 0.02);
  EXPECT_EQ(LightFactor(light, 0, 8.001), 1);
}

TEST(Light, TheShadowIsDarkAndTheRestUntouched) {
  const cv::Mat picture = Ramps(1);
  size_t num_dark = 0, num_lit = 0;
  for (double seconds = 0; seconds < 20; seconds += 0.7) {
    const cv::Mat shaded = InLight({LightKind::kShade, 0, 1}, 0, seconds, picture);
    for (int y = 0; y < picture.rows; ++y) {
      for (int x = 0; x < picture.cols; ++x) {
        const bool is_dark = IsInShadow(LightKind::kShade, seconds, {x, y}, picture.size());
        const double before = picture.at<uint8_t>(y, x), factor = is_dark ? std::pow(0.03, 1 / 2.2) : 1;
        ASSERT_NEAR(shaded.at<uint8_t>(y, x), before * factor, 1.5) << seconds << " s, " << x << ", " << y;
        ++(is_dark ? num_dark : num_lit);
      }
    }
  }
  EXPECT_GT(num_dark, num_lit / 4);
  EXPECT_GT(num_lit, num_dark / 4);
}

TEST(Light, SeedAndFrameAloneDecide) {
  const cv::Mat picture = Ramps();
  for (const LightKind kind : {LightKind::kSteady, LightKind::kFlicker, LightKind::kDim}) {
    const cv::Mat once = InLight({kind, 1, 4}, 9, 0.3, picture);
    EXPECT_TRUE(AreEqual(once, InLight({kind, 1, 4}, 9, 0.3, picture))) << ToString(kind);
    EXPECT_FALSE(AreEqual(once, InLight({kind, 1, 5}, 9, 0.3, picture))) << ToString(kind);
    EXPECT_FALSE(AreEqual(once, InLight({kind, 1, 4}, 10, 0.3, picture))) << ToString(kind);
  }
}

TEST(Light, NoiseIsASensorsInElectrons) {
  constexpr double kLevel = 240, kWell = 4000, kRead = 5;
  const cv::Mat flat(200, 200, CV_8UC1, cv::Scalar(kLevel));
  for (const LightKind kind : {LightKind::kSteady, LightKind::kDim}) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(InLight({kind, 1, 1}, 0, 0, flat), mean, deviation);
    const double light = std::pow(kLevel / 255, 2.2) * LightFactor({kind, 1, 1}, 0, 0), electrons = light * kWell;
    // d grey / d light of grey = 255 * light^(1/2.2)
    const double slope = 255 / 2.2 * std::pow(light, 1 / 2.2 - 1) / kWell;
    const double expected = slope * std::sqrt(electrons + kRead * kRead);
    EXPECT_NEAR(deviation[0], expected, 0.1 * expected) << ToString(kind);
    EXPECT_NEAR(mean[0], 255 * std::pow(light, 1 / 2.2), 0.5) << ToString(kind);
  }
}

/// One picture, again and again.
class StillDataset : public Dataset {
 public:
  explicit StillDataset(bool is_grey) : is_grey_(is_grey) {}
  size_t size() const override { return 3; }
  Timestamp TimeOf(size_t i) const override { return {static_cast<int64_t>(i) * 5'000'000'000}; }
  std::string PictureName(size_t i) const override { return std::to_string(i); }
  const Rig& rig() const override { return rig_; }
  Result<LoadedFrame> Load(size_t i) const override {
    LoadedFrame frame;
    if (i == 2) return frame;
    ImageSet images;
    images.timestamp = TimeOf(i);
    images.grey = Ramps(1);
    if (!is_grey_) images.colour = Ramps(3);
    images.depth.pixels = cv::Mat(96, 128, CV_16UC1, cv::Scalar(1500));
    frame.images = std::move(images);
    return frame;
  }

 private:
  bool is_grey_;
  Rig rig_;
};

TEST(LightDataset, ColourAndGreyChangeTogetherAndDepthStays) {
  const StillDataset still(false);
  const LightDataset changed(still, {LightKind::kSwitch, 1, 1});
  EXPECT_EQ(changed.size(), 3u);
  const auto frame = changed.Load(1);
  ASSERT_TRUE(frame.ok() && frame->images);
  cv::Mat grey;
  cv::cvtColor(frame->images->colour, grey, cv::COLOR_BGR2GRAY);
  EXPECT_TRUE(AreEqual(grey, frame->images->grey));
  EXPECT_LT(MeanOf(grey), MeanOf(Ramps()) / 4);
  EXPECT_TRUE(AreEqual(frame->images->depth.pixels, cv::Mat(96, 128, CV_16UC1, cv::Scalar(1500))));
  EXPECT_FALSE(changed.Load(2)->images) << "a frame that cannot be read stays so";
}

TEST(LightDataset, GreySourcesChangeToo) {
  const StillDataset still(true);
  const auto frame = LightDataset(still, {LightKind::kDim, 1, 1}).Load(0);
  ASSERT_TRUE(frame.ok() && frame->images);
  EXPECT_TRUE(frame->images->colour.empty());
  EXPECT_LT(MeanOf(frame->images->grey), MeanOf(Ramps()) / 4);
}

TEST(LightDataset, SteadyWithoutNoiseIsTheRecording) {
  const StillDataset still(false);
  const auto frame = LightDataset(still, {LightKind::kSteady, 0, 1}).Load(0);
  EXPECT_TRUE(AreEqual(frame->images->grey, Ramps(1)));
  EXPECT_TRUE(AreEqual(frame->images->colour, Ramps(3)));
}

}  // namespace
}  // namespace yorb

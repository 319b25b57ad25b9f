// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/descriptor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/blur.h"
#include "features/hamming.h"
#include "features/orb_pattern.h"
#include "features/test_pictures.h"

namespace yorb {
namespace {

/// The slow twin: the pattern turned and read pixel by pixel.
Descriptor SlowDescriptor(const GreyView& blurred, int x, int y, float angle_rad) {
  const float a = std::cos(angle_rad), b = std::sin(angle_rad);
  const auto pixel = [&](float u, float v) {
    return blurred.Row(y + static_cast<int>(std::lrint(u * b + v * a)))[x + std::lrint(u * a - v * b)];
  };
  Descriptor descriptor{};
  for (size_t i = 0; i < 256; ++i) {
    const OrbPair& pair = kOrbPairs[i];
    if (pixel(pair.x1, pair.y1) < pixel(pair.x2, pair.y2)) descriptor[i / 64] |= uint64_t{1} << (i % 64);
  }
  return descriptor;
}

/// The intensity centroid over all pixels whose rounded distance fits the round patch of 31 pixels.
float SlowOrientation(const GreyView& level, int x, int y) {
  const int half_width[] = {15, 15, 15, 15, 14, 14, 14, 13, 13, 12, 11, 10, 9, 8, 6, 3};
  double sum_x = 0, sum_y = 0;
  for (int v = -15; v <= 15; ++v) {
    for (int u = -half_width[std::abs(v)]; u <= half_width[std::abs(v)]; ++u) {
      sum_x += u * level.Row(y + v)[x + u];
      sum_y += v * level.Row(y + v)[x + u];
    }
  }
  const double angle = std::atan2(sum_y, sum_x);
  return static_cast<float>(angle < 0 ? angle + 2 * std::numbers::pi : angle);
}

TEST(Descriptor, AllPathsGiveTheSlowTwinsBits) {
  const GreyImage image = Padded(NoisePicture(200, 150, 1));
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const int x = 19 + static_cast<int>(random.Below(200 - 38)), y = 19 + static_cast<int>(random.Below(150 - 38));
    const float angle = static_cast<float>(random.Uniform(0, 2 * std::numbers::pi));
    const Descriptor expected = SlowDescriptor(image.View(), x, y, angle);
    EXPECT_EQ(DescribeAt(image.View(), x, y, angle, Instructions::kPortable), expected);
    EXPECT_EQ(DescribeAt(image.View(), x, y, angle, BestInstructions()), expected);
  }
}

TEST(Descriptor, AllPathsGiveTheSlowTwinsAngle) {
  const GreyImage image = Padded(RectanglesPicture(200, 150, 3));
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const int x = 19 + static_cast<int>(random.Below(200 - 38)), y = 19 + static_cast<int>(random.Below(150 - 38));
    const float angle = OrientationOf(image.View(), x, y, Instructions::kPortable);
    EXPECT_EQ(OrientationOf(image.View(), x, y, BestInstructions()), angle);
    EXPECT_GE(angle, 0);
    EXPECT_LT(angle, 2 * std::numbers::pi);
    const double difference = std::abs(angle - SlowOrientation(image.View(), x, y));
    EXPECT_LT(std::min(difference, 2 * std::numbers::pi - difference), 0.006) << "fastAtan2 is good to 0.3 degrees";
  }
}

TEST(Descriptor, BrightestAndDarkestPatchesDoNotOverflow) {
  cv::Mat picture(64, 64, CV_8UC1, cv::Scalar(0));
  picture(cv::Rect(32, 0, 32, 64)).setTo(255);
  const GreyImage image = Padded(picture);
  for (const Instructions path : {Instructions::kPortable, BestInstructions()}) {
    EXPECT_NEAR(OrientationOf(image.View(), 31, 31, path), SlowOrientation(image.View(), 31, 31), 0.006);
  }
}

TEST(Descriptor, TurnsWithThePicture) {
  cv::Mat picture = RectanglesPicture(121, 121, 5, 0), turned;
  cv::GaussianBlur(picture, picture, cv::Size(7, 7), 2);
  const GreyImage image = Padded(picture);
  const float angle = OrientationOf(image.View(), 60, 60, BestInstructions());
  const Descriptor upright = DescribeAt(image.View(), 60, 60, angle, BestInstructions());
  for (const double degrees : {90.0, 37.0, 200.0}) {
    const cv::Mat turn = cv::getRotationMatrix2D(cv::Point2f(60, 60), -degrees, 1);
    cv::warpAffine(picture, turned, turn, picture.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT_101);
    const GreyImage turned_image = Padded(turned);
    const float turned_angle = OrientationOf(turned_image.View(), 60, 60, BestInstructions());
    const double expected = std::remainder(angle + degrees * std::numbers::pi / 180, 2 * std::numbers::pi);
    EXPECT_NEAR(std::remainder(turned_angle - expected, 2 * std::numbers::pi), 0, 0.05);
    const Descriptor other = DescribeAt(turned_image.View(), 60, 60, turned_angle, BestInstructions());
    EXPECT_LT(HammingDistance(upright, other), 40) << degrees;
  }
}

}  // namespace
}  // namespace yorb

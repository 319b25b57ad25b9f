// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/sensor.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/stats.h"
#include "synthetic/sequence.h"

namespace yorb {
namespace {

struct Measured {
  double deviation = 0, bias = 0, hole_share = 0;
};

// A wall straight ahead at a depth.
Measured MeasureWall(float depth, double noise) {
  const Rig rig = SyntheticRig(320, 240);
  const cv::Mat exact(240, 320, CV_32FC1, cv::Scalar::all(depth));
  const cv::Mat units = MeasureDepth({noise, 4}, 7, rig, exact);
  std::vector<double> errors;
  for (int y = 0; y < units.rows; ++y) {
    for (int x = 0; x < units.cols; ++x) {
      if (units.at<uint16_t>(y, x) > 0) errors.push_back(units.at<uint16_t>(y, x) / rig.depth_factor - depth);
    }
  }
  const Summary summary = Summarize(errors);
  return {summary.std, summary.mean, 1 - static_cast<double>(errors.size()) / static_cast<double>(units.total())};
}

TEST(MeasureDepth, IsExactToHalfAUnitWithoutNoise) {
  for (const float depth : {0.3f, 1.23456f, 4.f, 9.f}) {
    const Measured wall = MeasureWall(depth, 0);
    EXPECT_NEAR(wall.bias, 0, 0.5 / 5000 + 1e-6);
    EXPECT_EQ(wall.deviation, 0);
    EXPECT_EQ(wall.hole_share, 0);
  }
}

TEST(MeasureDepth, ErrsWithTheSquareOfDepth) {
  const double near = MeasureWall(1.01f, 1).deviation, middle = MeasureWall(2.02f, 1).deviation,
               far = MeasureWall(4.04f, 1).deviation;
  EXPECT_NEAR(middle / near, 4, 1);
  EXPECT_NEAR(far / middle, 4, 1);
  EXPECT_GT(far, 0.018);
  EXPECT_LT(far, 0.035);
  EXPECT_LT(std::abs(MeasureWall(4.04f, 1).bias), 0.3 * far);
  EXPECT_NEAR(MeasureWall(4.04f, 4).deviation / far, 4, 1);
}

TEST(MeasureDepth, SeesLittleFarAwayAndNothingCloseUp) {
  EXPECT_EQ(MeasureWall(0.4f, 1).hole_share, 1);
  EXPECT_LT(MeasureWall(2, 1).hole_share, 0.01);
  const double at_five = MeasureWall(5, 1).hole_share, at_six = MeasureWall(6, 1).hole_share;
  EXPECT_GT(at_five, 0.005);
  EXPECT_GT(at_six, 0.3);
  EXPECT_GT(MeasureWall(8, 1).hole_share, 0.95);
}

TEST(MeasureDepth, LeavesAShadowBesideNearThings) {
  const Rig rig = SyntheticRig(640, 480);
  cv::Mat exact(480, 640, CV_32FC1, cv::Scalar::all(3));
  exact.colRange(300, 400).setTo(1);
  const cv::Mat units = MeasureDepth({1, 4}, 7, rig, exact);
  // Disparities differ by 0.075 m * 535 px * (1/1 m - 1/3 m) = 26.8 px: so wide is the shadow, on one side alone.
  EXPECT_LT(cv::countNonZero(units.colRange(300 - 25, 300)), 10);
  EXPECT_GT(cv::countNonZero(units.colRange(300 - 40, 300 - 28)), 0.95 * 12 * 480);
  EXPECT_GT(cv::countNonZero(units.colRange(402, 440)), 0.95 * 38 * 480);
}

TEST(AddColourNoise, HasNoBiasAndDependsOnFrameAndSeed) {
  const cv::Mat grey(240, 320, CV_8UC3, cv::Scalar::all(120));
  cv::Mat first = grey.clone(), again = grey.clone(), later = grey.clone(), clean = grey.clone();
  AddColourNoise({1, 4}, 7, first);
  AddColourNoise({1, 4}, 7, again);
  AddColourNoise({1, 4}, 8, later);
  AddColourNoise({0, 4}, 7, clean);
  cv::Scalar mean, deviation;
  cv::meanStdDev(first, mean, deviation);
  EXPECT_NEAR(mean[1], 120, 0.3);
  EXPECT_NEAR(deviation[1], 2.1, 0.4);
  EXPECT_EQ(cv::norm(first, again), 0);
  EXPECT_GT(cv::norm(first, later), 0);
  EXPECT_EQ(cv::norm(grey, clean), 0);
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/seen_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "map/synthetic_world.h"

namespace yorb {
namespace {

/// A frame of a camera with a rolling shutter, without points.
Frame Empty(double readout_s) {
  Rig rig = SyntheticWorld(1).rig();
  rig.readout_s = readout_s;
  Frame frame;
  frame.rig = std::make_shared<const Rig>(rig);
  return frame;
}

/// The picture of bright posts far away, one in each direction `across` of the camera, as rows read one after the other
/// see them.
cv::Mat Posts(const Rig& rig, const CameraRate& rate, const Eigen::Vector3d& up) {
  constexpr double kHalfWidth = 0.02;
  cv::Mat grey(rig.camera.height, rig.camera.width, CV_8UC1, cv::Scalar(40));
  for (int y = 0; y < grey.rows; ++y) {
    const Rigid3 moved = rate.After(rig.readout_s * (static_cast<double>(y) / rig.camera.height - 0.5));
    for (int x = 0; x < grey.cols; ++x) {
      const Eigen::Vector3d ray = moved.Inverse().rotation * rig.camera.Unproject(x, y, 1);
      for (const double across : {-0.25, 0.0, 0.25}) {
        const Eigen::Vector3d ahead = Eigen::Vector3d(across, 0, 1);
        const double side = ray.dot(up.cross(ahead).normalized()) / ray.norm();
        if (std::abs(side) < kHalfWidth) grey.at<uint8_t>(y, x) = 220;
      }
    }
  }
  cv::GaussianBlur(grey, grey, {}, 0.8);
  return grey;
}

/// The largest sine of the angle between the lines' planes and a direction.
double FarthestFrom(const Eigen::Vector3d& direction, const std::vector<LineSight>& lines) {
  double most = 0;
  for (const LineSight& line : lines) most = std::max(most, std::abs(line.normal.cast<double>().dot(direction)));
  return most;
}

TEST(SeeLines, TheirPlanesHoldTheDirectionInWhichTheyRun) {
  const Frame frame = Empty(0);
  const Eigen::Vector3d up = RotationFromVector({0.3, 0, 0.2}) * Eigen::Vector3d::UnitY();
  const std::vector<LineSight> lines = *SeeLines({{}, Posts(*frame.rig, {}, up), {}, 0}, frame, {});
  ASSERT_GE(lines.size(), 6u) << "both sides of each post";
  EXPECT_LT(FarthestFrom(up, lines), 0.01);
  for (const LineSight& line : lines) {
    EXPECT_NEAR(line.normal.norm(), 1, 1e-5);
    EXPECT_GT(line.sigma, 0.005f);
    EXPECT_LT(line.sigma, 0.03f);
  }
}

TEST(SeeLines, ARollingShutterIsUndone) {
  const Frame frame = Empty(0.03);
  const CameraRate rate{{0, 1.0, 0}, {0, 0, 0}};
  const auto up = Eigen::Vector3d::UnitY();
  const Sight sight{{}, Posts(*frame.rig, rate, up), {}, 0};
  const std::vector<LineSight> slanted = *SeeLines(sight, frame, {}), upright = *SeeLines(sight, frame, rate);
  ASSERT_GE(slanted.size(), 6u);
  ASSERT_EQ(upright.size(), slanted.size());
  EXPECT_GT(FarthestFrom(up, slanted), 0.02) << "a turn of a radian a second is seen in the slant";
  EXPECT_LT(FarthestFrom(up, upright), 0.006);
}

TEST(SeeLines, NeedAPicture) { EXPECT_TRUE(SeeLines({}, Empty(0), {})->empty()); }

}  // namespace
}  // namespace yorb

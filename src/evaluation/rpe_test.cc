// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/rpe.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "evaluation/test_trajectories.h"

namespace yorb {
namespace {

Eigen::Matrix4d Matrix(const Rigid3& pose) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = pose.rotation.toRotationMatrix();
  matrix.topRightCorner<3, 1>() = pose.translation;
  return matrix;
}

size_t Nearest(const std::vector<double>& values, double wanted) {
  const auto nearer = [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); };
  return static_cast<size_t>(std::min_element(values.begin(), values.end(), nearer) - values.begin());
}

/// TUM's evaluate_rpe.py in matrices, with a linear search.
std::vector<double> SlowTwin(const Trajectory& reference, const Trajectory& estimate, const RpeOptions& options) {
  std::vector<double> truth, position(1, 0.0), result;
  for (const StampedPose& pose : reference) truth.push_back(pose.timestamp.seconds());
  for (size_t i = 1; i < estimate.size(); ++i) {
    const Eigen::Matrix4d step = Matrix(estimate[i].world_from_cam).inverse() * Matrix(estimate[i - 1].world_from_cam);
    position.push_back(position.back() + options.scale * step.topRightCorner<3, 1>().norm());
  }
  for (size_t i = 0; i < estimate.size(); ++i) {
    if (options.unit == RpeUnit::kFrames) position[i] = static_cast<double>(i);
    if (options.unit == RpeUnit::kSeconds) position[i] = estimate[i].timestamp.seconds();
  }
  for (size_t i = 0; i < estimate.size(); ++i) {
    const size_t j = Nearest(position, position[i] + options.delta);
    if (j == estimate.size() - 1) continue;
    const size_t k = Nearest(truth, estimate[i].timestamp.seconds() + options.offset),
                 l = Nearest(truth, estimate[j].timestamp.seconds() + options.offset);
    Eigen::Matrix4d found = Matrix(estimate[j].world_from_cam).inverse() * Matrix(estimate[i].world_from_cam);
    found.topRightCorner<3, 1>() *= options.scale;
    const Eigen::Matrix4d wanted = Matrix(reference[l].world_from_cam).inverse() * Matrix(reference[k].world_from_cam);
    const Eigen::Matrix4d error = found.inverse() * wanted;
    result.push_back(error.topRightCorner<3, 1>().norm());
  }
  return result;
}

TEST(Rpe, EqualsTheSlowTwinInEveryUnit) {
  const Trajectory truth = SmoothWalk(900, 10), walk = SmoothWalk(180, 33, 1501);
  const Trajectory estimate = Disturbed(walk, 0.01, SomeMotion(0.4), 3);
  for (const RpeUnit unit : {RpeUnit::kSeconds, RpeUnit::kMetres, RpeUnit::kFrames}) {
    RpeOptions options;
    options.unit = unit;
    options.delta = unit == RpeUnit::kFrames ? 7 : 0.6;
    options.scale = 2.5;
    options.offset = 0.0042;  // so that no two true stamps are equally near
    const RelativeError error = ComputeRelativeError(truth, estimate, options);
    const std::vector<double> twin = SlowTwin(truth, estimate, options);
    ASSERT_EQ(error.translation.size(), twin.size());
    ASSERT_GT(twin.size(), 100u);
    for (size_t i = 0; i < twin.size(); ++i) EXPECT_NEAR(error.translation[i], twin[i], 1e-9);
  }
}

TEST(Rpe, AMovedWorldAndItsScaleMakeNoError) {
  const Trajectory truth = SmoothWalk(300, 10);
  RpeOptions options;
  options.scale = 1 / 0.31;
  const RelativeError error = ComputeRelativeError(truth, Disturbed(truth, 0, SomeMotion(0.31), 1), options);
  ASSERT_GT(error.translation_summary.count, 150u);
  EXPECT_LT(error.translation_summary.max, 1e-9);
  EXPECT_LT(error.rotation_summary.max, 1e-5);
}

TEST(Rpe, SteadyDriftIsMeasuredExactly) {
  const Trajectory truth = SmoothWalk(400, 10);
  Trajectory estimate = truth;
  for (StampedPose& pose : estimate) {  // turns by 2 degrees a second too much
    const double seconds = SecondsBetween(truth[0].timestamp, pose.timestamp);
    pose.world_from_cam.rotation = pose.world_from_cam.rotation * RotationFromVector({0, 0, seconds * 2 * M_PI / 180});
  }
  Trajectory still_truth = truth;
  for (Trajectory* poses : {&still_truth, &estimate}) {
    for (StampedPose& pose : *poses)
      pose.world_from_cam = Rigid3(pose.world_from_cam.rotation, Eigen::Vector3d::Zero());
  }
  for (StampedPose& pose : still_truth) pose.world_from_cam.rotation = Eigen::Quaterniond::Identity();
  for (size_t i = 0; i < estimate.size(); ++i) {
    estimate[i].world_from_cam.rotation =
        truth[i].world_from_cam.rotation.conjugate() * estimate[i].world_from_cam.rotation;
  }
  const RelativeError error = ComputeRelativeError(still_truth, estimate, {});
  EXPECT_NEAR(error.rotation_summary.min, 2.0, 1e-6);
  EXPECT_NEAR(error.rotation_summary.max, 2.0, 1e-6);
}

TEST(Rpe, PairsThatEndOnTheLastPoseAreDropped) {
  const Trajectory truth = SmoothWalk(101, 100);  // 10 s
  EXPECT_EQ(ComputeRelativeError(truth, truth, {}).translation.size(), 90u);
  RpeOptions too_long;
  too_long.delta = 11;
  EXPECT_TRUE(ComputeRelativeError(truth, truth, too_long).translation.empty());
}

TEST(Rpe, TruthFarInTimeIsNotUsed) {
  Trajectory truth = SmoothWalk(1000, 10);
  truth.erase(truth.begin() + 400, truth.begin() + 500);
  const Trajectory estimate = SmoothWalk(333, 30);
  const size_t whole = ComputeRelativeError(SmoothWalk(1000, 10), estimate, {}).translation.size();
  const size_t holed = ComputeRelativeError(truth, estimate, {}).translation.size();
  EXPECT_LT(holed, whole - 50);
  EXPECT_GT(holed, whole - 80);
}

TEST(Rpe, PairsAcrossGapsAreCounted) {
  Trajectory estimate = SmoothWalk(300, 33);
  EXPECT_EQ(ComputeRelativeError(SmoothWalk(1000, 10), estimate, {}).num_odd, 0u);
  estimate.erase(estimate.begin() + 100, estimate.begin() + 200);
  EXPECT_GT(ComputeRelativeError(SmoothWalk(1000, 10), estimate, {}).num_odd, 10u);
}

TEST(Rpe, TooFewPosesGiveNoPairs) {
  const Trajectory truth = SmoothWalk(100, 10);
  EXPECT_TRUE(ComputeRelativeError(truth, {}, {}).translation.empty());
  EXPECT_TRUE(ComputeRelativeError({}, truth, {}).translation.empty());
  EXPECT_TRUE(ComputeRelativeError({truth[0]}, truth, {}).translation.empty());
}

}  // namespace
}  // namespace yorb

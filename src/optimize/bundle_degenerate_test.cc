// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Bundle adjustment where little or nothing is determined, or the input is broken: finite values come out.
#include <gtest/gtest.h>

#include <algorithm>

#include "optimize/bundle.h"
#include "optimize/test_problems.h"

namespace yorb {
namespace {

WorldProblem SixViews(const Noise& noise) {
  WorldOptions options;
  options.noise = noise;
  options.poses = 6, options.points = 150;
  options.range = 1;
  return MakeWorld(options);
}

BundleResult ExpectFinite(const BundleProblem& problem) {
  BundleResult result = AdjustBundle(problem, {});
  for (const Rigid3& pose : result.poses) EXPECT_TRUE(pose.IsFinite());
  for (const Eigen::Vector3d& point : result.points) EXPECT_TRUE(point.allFinite());
  EXPECT_TRUE(std::isfinite(result.initial_cost) && std::isfinite(result.final_cost));
  EXPECT_LE(result.final_cost, result.initial_cost);
  EXPECT_EQ(result.is_outlier.size(), problem.seen.size());
  return result;
}

TEST(AdjustBundleDegenerate, BrokenObservationsAndPointsAreOutliers) {
  WorldProblem world = SixViews({0, 0, 0});
  auto& seen = world.problem.seen;
  seen[0].observation.x_px = kNan;
  seen[1].observation.inverse_variance = kNan;
  seen[2].observation.inverse_variance = -1;
  seen[3].observation.right_px = std::numeric_limits<double>::infinity();
  seen[4].observation.y_px = -std::numeric_limits<double>::infinity();
  const uint32_t broken = seen[5].point;
  world.problem.points[broken].y() = kNan;
  const BundleResult result = AdjustBundle(world.problem, {});
  for (size_t k = 0; k < seen.size(); ++k) EXPECT_EQ(result.is_outlier[k], k < 5 || seen[k].point == broken) << k;
  for (size_t k = 0; k < 6; ++k) EXPECT_LT(PoseDistance(result.poses[k], world.true_poses[k]), 1e-7);
  for (size_t k = 0; k < result.points.size(); ++k) EXPECT_EQ(result.points[k].allFinite(), k != broken);
}

TEST(AdjustBundleDegenerate, PointsBehindACameraAreOutliersAndPullAtNothing) {
  WorldProblem world = SixViews({0, 0, 0});
  for (uint32_t point = 0; point < 20; ++point) world.problem.points[point] = Eigen::Vector3d(0.5, 0, -1.0 - point);
  const BundleResult result = ExpectFinite(world.problem);
  for (size_t k = 0; k < world.problem.seen.size(); ++k) {
    EXPECT_EQ(result.is_outlier[k], world.problem.seen[k].point < 20) << k;
  }
  for (size_t k = 0; k < 6; ++k) EXPECT_LT(PoseDistance(result.poses[k], world.true_poses[k]), 1e-7);
}

TEST(AdjustBundleDegenerate, PointsThatStartVeryFarAwayStayFinite) {
  for (const double far : {1e2, 1e4, 1e9, 1e100}) {
    WorldProblem world = SixViews({0, 0, 0.3});
    for (uint32_t point = 0; point < 20; ++point)
      world.problem.points[point] = Eigen::Vector3d(0.5, 0, far * (1 + point));
    ExpectFinite(world.problem);
  }
}

TEST(AdjustBundleDegenerate, PointsSeenOnceWithoutDepthDoNoHarm) {
  WorldProblem world = SixViews({0, 0, 0.3});
  Random random(5);
  for (uint32_t pose = 0; pose < 6; ++pose) {
    for (int k = 0; k < 30; ++k) {
      const auto point = static_cast<uint32_t>(world.problem.points.size());
      world.problem.points.push_back(world.true_poses[pose].Inverse() * (Eigen::Vector3d(0, 0, 2) + InCube(random, 1)));
      world.problem.seen.push_back({pose, point, {random.Uniform(0, 640), random.Uniform(0, 480), kNan, 1}});
    }
  }
  const BundleResult result = ExpectFinite(world.problem);
  for (size_t k = 0; k < 6; ++k) EXPECT_LT(PoseDistance(result.poses[k], world.true_poses[k]), 1e-5);
}

TEST(AdjustBundleDegenerate, CamerasThatOnlyTurnOrStandStillGiveNoDepth) {
  for (const double angle : {0.0, 0.2}) {
    WorldProblem world = SixViews({1, 0, 1});
    const Rigid3 first = world.true_poses[0];
    BundleProblem& problem = world.problem;
    problem.seen.clear();
    Random random(3);
    for (uint32_t pose = 0; pose < 6; ++pose) {
      problem.poses[pose] = Rigid3(RotationFromVector({0, angle * pose / 6, 0}), {0, 0, 0}) * first;
      for (uint32_t point = 0; point < 150; ++point) {
        const Eigen::Vector3d x = problem.poses[pose] * world.true_points[point];
        if (x.z() > 0.1) problem.seen.push_back({pose, point, Observe(x, problem.projection, {1, 0, 1}, random)});
      }
    }
    problem.is_fixed = {true, false, false, false, false, false};
    ExpectFinite(problem);
  }
}

TEST(AdjustBundleDegenerate, NoFixedPoseNeedsNoGauge) {
  WorldProblem world = SixViews({0, 0, 0});
  std::fill(world.problem.is_fixed.begin(), world.problem.is_fixed.end(), false);
  const BundleResult result = ExpectFinite(world.problem);
  EXPECT_LT(result.final_cost, 1e-8);
  const Rigid3 found = result.poses[5] * result.poses[0].Inverse();
  EXPECT_LT(PoseDistance(found, world.true_poses[5] * world.true_poses[0].Inverse()), 1e-5);
}

TEST(AdjustBundleDegenerate, AllPosesFixedMovesPointsOnly) {
  WorldProblem world = SixViews({0, 0, 0});
  std::fill(world.problem.is_fixed.begin(), world.problem.is_fixed.end(), true);
  world.problem.poses = world.true_poses;
  const BundleResult result = ExpectFinite(world.problem);
  for (const BundleProblem::Seen& seen : world.problem.seen) {
    EXPECT_LT((result.points[seen.point] - world.true_points[seen.point]).norm(), 1e-6);
  }
}

TEST(AdjustBundleDegenerate, EmptyProblemsAndUnseenRowsComeBackAsTheyWere) {
  const BundleResult nothing = ExpectFinite({});
  EXPECT_TRUE(nothing.poses.empty() && nothing.points.empty() && nothing.iterations == 0);
  WorldProblem world = SixViews({1, 0, 0});
  world.problem.poses.push_back(Rigid3(Eigen::Quaterniond::Identity(), {1, 2, 3}));
  world.problem.is_fixed.push_back(false);
  world.problem.points.push_back({4, 5, 6});
  const BundleResult result = ExpectFinite(world.problem);
  EXPECT_EQ(result.poses.back().translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(result.points.back(), Eigen::Vector3d(4, 5, 6));
}

TEST(AdjustBundleDegenerate, WildGuessesStayFinite) {
  for (uint64_t seed = 0; seed < 10; ++seed) {
    WorldOptions options;
    options.poses = 6, options.points = 60;
    options.noise = {1, 0.2, 0.5};
    options.pose_error = 1.5, options.point_error = 3;
    options.seed = seed;
    ExpectFinite(MakeWorld(options).problem);
  }
}

}  // namespace
}  // namespace yorb

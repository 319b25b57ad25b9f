// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/bundle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "optimize/bundle_step.h"
#include "optimize/ceres_oracle.h"
#include "optimize/test_problems.h"

namespace yorb {
namespace {

std::vector<bool> All(const BundleProblem& problem) { return std::vector<bool>(problem.seen.size(), true); }

std::vector<bool> Flipped(std::vector<bool> flags) {
  flags.flip();
  return flags;
}

size_t Count(const std::vector<bool>& flags) {
  return static_cast<size_t>(std::count(flags.begin(), flags.end(), true));
}

double PoseDistance(const Rigid3& a, const Rigid3& b) {
  const Rigid3 difference = a * b.Inverse();
  return difference.translation.norm() + difference.RotationAngle();
}

double PlainCost(const BundleProblem& problem, const BundleResult& result) {
  double cost = 0;
  for (size_t k = 0; k < problem.seen.size(); ++k) {
    const auto& [pose, point, seen] = problem.seen[k];
    if (!result.is_outlier[k]) cost += 0.5 * Chi2(result.poses[pose] * result.points[point], seen, problem.projection);
  }
  return cost;
}

void ExpectFinite(const BundleResult& result) {
  for (const Rigid3& pose : result.poses) EXPECT_TRUE(pose.IsFinite());
  for (const Eigen::Vector3d& point : result.points) EXPECT_TRUE(point.allFinite());
  EXPECT_TRUE(std::isfinite(result.initial_cost) && std::isfinite(result.final_cost));
}

TEST(AdjustBundle, RecoversTruthFromNoiseFreeObservations) {
  WorldOptions options;
  options.noise = {0, 0, 0.3};
  options.poses = 8, options.points = 200;
  const WorldProblem world = MakeWorld(options);
  const BundleResult result = AdjustBundle(world.problem, {});
  EXPECT_LT(result.final_cost, 1e-12);
  EXPECT_EQ(Count(result.is_outlier), 0u);
  for (size_t k = 0; k < result.poses.size(); ++k) EXPECT_LT(PoseDistance(result.poses[k], world.true_poses[k]), 1e-7);
}

TEST(AdjustBundle, ReachesTheCostOfCeres) {
  for (const double without_depth : {0.0, 0.5}) {
    WorldOptions options;
    options.noise = {1, 0, without_depth};
    options.poses = 10, options.points = 300;
    const WorldProblem world = MakeWorld(options);
    const BundleResult result = AdjustBundle(world.problem, {});
    const CeresBundleResult oracle = CeresAdjustBundle(world.problem, All(world.problem), false, 1e-12);
    EXPECT_EQ(Count(result.is_outlier), 0u);
    EXPECT_NEAR(result.final_cost, oracle.cost, 1e-6 * oracle.cost);
    for (size_t k = 0; k < result.poses.size(); ++k) EXPECT_LT(PoseDistance(result.poses[k], oracle.poses[k]), 1e-4);
  }
}

TEST(AdjustBundle, TakesOutliersOutAndThenReachesTheCostOfCeres) {
  WorldOptions options;
  options.noise = {1, 0.1, 0.3};
  options.poses = 10, options.points = 300;
  const WorldProblem world = MakeWorld(options);
  BundleOptions until_settled;
  until_settled.second_rounds = until_settled.second_iterations = 50;
  const BundleResult result = AdjustBundle(world.problem, until_settled);
  const CeresBundleResult oracle = CeresAdjustBundle(world.problem, Flipped(result.is_outlier), false, 1e-12);
  std::cout << Count(result.is_outlier) << " of " << world.problem.seen.size() << " its " << result.iterations << "\n";
  EXPECT_NEAR(PlainCost(world.problem, result), oracle.cost, 1e-6 * oracle.cost);
}

}  // namespace
}  // namespace yorb

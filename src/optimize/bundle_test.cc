// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/bundle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "optimize/ceres_oracle.h"
#include "optimize/test_tours.h"

namespace yorb {
namespace {

std::vector<bool> Flipped(std::vector<bool> flags) {
  flags.flip();
  return flags;
}

size_t Count(const std::vector<bool>& flags) {
  return static_cast<size_t>(std::count(flags.begin(), flags.end(), true));
}

double PlainCost(const BundleProblem& problem, const BundleResult& result) {
  double cost = 0;
  for (size_t k = 0; k < problem.seen.size(); ++k) {
    const auto& [pose, point, seen] = problem.seen[k];
    if (!result.is_outlier[k]) cost += 0.5 * Chi2(result.poses[pose] * result.points[point], seen, problem.projection);
  }
  return cost;
}

WorldProblem SmallWorld(const Noise& noise, uint64_t seed = 1) {
  WorldOptions options;
  options.noise = noise;
  options.poses = 10, options.points = 300;
  options.seed = seed;
  return MakeWorld(options);
}

BundleOptions UntilSettled() {
  BundleOptions options;
  options.second_rounds = options.second_iterations = 50;
  return options;
}

void ExpectTruth(const WorldProblem& world, const BundleResult& result) {
  for (size_t k = 0; k < result.poses.size(); ++k) EXPECT_LT(PoseDistance(result.poses[k], world.true_poses[k]), 1e-7);
}

TEST(AdjustBundle, RecoversTruthFromNoiseFreeObservations) {
  const WorldProblem world = SmallWorld({0, 0, 0.3});
  const BundleResult result = AdjustBundle(world.problem, {});
  EXPECT_LT(result.final_cost, 1e-12);
  EXPECT_GT(result.initial_cost, 1000);
  EXPECT_EQ(Count(result.is_outlier), 0u);
  ExpectTruth(world, result);
}

TEST(AdjustBundle, RecoversTruthAmongAThirdOfOutliers) {
  const WorldProblem world = SmallWorld({0, 0.3, 0.3});
  const BundleResult result = AdjustBundle(world.problem, UntilSettled());
  ExpectTruth(world, result);
  // Where two sights of one point are wrong alike, the right one may be the odd one out.
  const double share = static_cast<double>(Count(result.is_outlier)) / static_cast<double>(world.problem.seen.size());
  EXPECT_GT(share, 0.25);
  EXPECT_LT(share, 0.45);
}

TEST(AdjustBundle, ReachesTheCostOfCeres) {
  for (const double without_depth : {0.0, 0.5, 1.0}) {
    const WorldProblem world = SmallWorld({1, 0, without_depth});
    const std::vector<bool> all(world.problem.seen.size(), true);
    BundleOptions options;
    options.second_iterations = 50;
    options.relative_tolerance = 1e-10;
    const BundleResult result = AdjustBundle(world.problem, options);
    const CeresBundleResult oracle = CeresAdjustBundle(world.problem, all, false, 1e-12);
    EXPECT_EQ(Count(result.is_outlier), 0u);
    EXPECT_NEAR(result.final_cost, oracle.cost, 1e-6 * oracle.cost) << without_depth;
    for (size_t k = 0; k < result.poses.size(); ++k) EXPECT_LT(PoseDistance(result.poses[k], oracle.poses[k]), 1e-4);
  }
}

TEST(AdjustBundle, ReachesTheCostOfCeresInTheSparseWay) {
  TourOptions options;
  options.poses = 120, options.points = 1500;
  options.noise = {1, 0, 0.3};
  const WorldProblem world = MakeTour(options);
  const std::vector<bool> all(world.problem.seen.size(), true);
  BundleOptions to_the_end = UntilSettled();
  to_the_end.first_iterations = 50;
  to_the_end.relative_tolerance = 1e-10;
  const BundleResult result = AdjustBundle(world.problem, to_the_end);
  const CeresBundleResult oracle = CeresAdjustBundle(world.problem, Flipped(result.is_outlier), false, 1e-12);
  EXPECT_LT(Count(result.is_outlier), world.problem.seen.size() / 100);
  EXPECT_NEAR(PlainCost(world.problem, result), oracle.cost, 1e-6 * oracle.cost);
}

TEST(AdjustBundle, TakesOutliersOutAndThenReachesTheCostOfCeres) {
  const WorldProblem world = SmallWorld({1, 0.1, 0.3});
  const BundleResult result = AdjustBundle(world.problem, UntilSettled());
  const CeresBundleResult oracle = CeresAdjustBundle(world.problem, Flipped(result.is_outlier), false, 1e-12);
  EXPECT_GT(Count(result.is_outlier), world.problem.seen.size() / 20);
  EXPECT_NEAR(PlainCost(world.problem, result), oracle.cost, 1e-6 * oracle.cost);
}

TEST(AdjustBundle, LowersTheRobustCostAsCeresDoes) {
  const WorldProblem world = SmallWorld({1, 0.1, 0});
  BundleOptions options;
  options.first_iterations = 50, options.second_iterations = 0;
  options.relative_tolerance = 1e-10;
  const BundleResult result = AdjustBundle(world.problem, options);
  const std::vector<bool> all(world.problem.seen.size(), true);
  const CeresBundleResult oracle = CeresAdjustBundle(world.problem, all, true, 1e-9);
  EXPECT_NEAR(result.final_cost, oracle.cost, 1e-5 * oracle.cost);  // both creep where most of a point is wrong
}

TEST(AdjustBundle, LeavesFixedPosesAsTheyAre) {
  WorldProblem world = SmallWorld({1, 0, 0});
  world.problem.is_fixed[5] = true;  // not where it should be, and yet
  const BundleResult result = AdjustBundle(world.problem, {});
  for (const size_t k : {0, 1, 5}) {
    EXPECT_EQ(result.poses[k].rotation.coeffs(), world.problem.poses[k].rotation.coeffs());
    EXPECT_EQ(result.poses[k].translation, world.problem.poses[k].translation);
  }
  EXPECT_GT(PoseDistance(result.poses[6], world.problem.poses[6]), 1e-3);
}

TEST(AdjustBundle, IsTheSameForTheSameInputAndForAnyOrder) {
  WorldProblem world = SmallWorld({1, 0.1, 0.3});
  const BundleResult a = AdjustBundle(world.problem, {}), b = AdjustBundle(world.problem, {});
  std::reverse(world.problem.seen.begin(), world.problem.seen.end());
  const BundleResult c = AdjustBundle(world.problem, {});
  for (size_t k = 0; k < a.poses.size(); ++k) {
    EXPECT_EQ(a.poses[k].translation, b.poses[k].translation);
    EXPECT_LT(PoseDistance(a.poses[k], c.poses[k]), 1e-9);
  }
  for (size_t k = 0; k < a.points.size(); ++k) EXPECT_LT((a.points[k] - c.points[k]).norm(), 1e-6);
  EXPECT_EQ(a.is_outlier, b.is_outlier);
  EXPECT_TRUE(std::equal(a.is_outlier.begin(), a.is_outlier.end(), c.is_outlier.rbegin()));
}

TEST(AdjustBundle, StopsWhenToldWithTheBestSoFar) {
  const WorldProblem world = SmallWorld({1, 0, 0});
  double last_cost = std::numeric_limits<double>::infinity();
  for (int patience = 0; patience < 4; ++patience) {
    int num_asked = 0;
    const BundleResult result = AdjustBundle(world.problem, {}, [&] { return ++num_asked > patience; });
    EXPECT_TRUE(result.was_stopped);
    EXPECT_EQ(num_asked, patience + 1);
    EXPECT_EQ(result.iterations, patience);
    EXPECT_LE(result.final_cost, last_cost);
    if (patience == 0) {
      EXPECT_EQ(result.final_cost, result.initial_cost);
      EXPECT_EQ(result.poses[5].translation, world.problem.poses[5].translation);
    } else {
      EXPECT_LT(result.final_cost, 0.1 * result.initial_cost);
    }
    last_cost = result.final_cost;
  }
  EXPECT_FALSE(AdjustBundle(world.problem, {}, [] { return false; }).was_stopped);
}

TEST(AdjustBundle, CountsSeveralSightsOfOnePointFromOnePose) {
  WorldProblem world = SmallWorld({1, 0, 0.5});
  const size_t count = world.problem.seen.size();
  for (size_t k = 0; k < count; k += 2) world.problem.seen.push_back(world.problem.seen[k]);
  const std::vector<bool> all(world.problem.seen.size(), true);
  const BundleResult result = AdjustBundle(world.problem, UntilSettled());
  const CeresBundleResult oracle = CeresAdjustBundle(world.problem, all, false, 1e-12);
  EXPECT_NEAR(result.final_cost, oracle.cost, 1e-6 * oracle.cost);
}

double CostOf(const BundleProblem& problem, const BundleResult& result) {
  double cost = PlainCost(problem, result);
  for (const BundleProblem::Tie& tie : problem.ties) {
    const Rigid3 off = result.poses[tie.to] * (tie.to_from_from * result.poses[tie.from]).Inverse();
    Vector6d error;
    error << VectorFromRotation(off.rotation), off.translation;
    cost += 0.5 * error.dot(tie.information * error);
  }
  return cost;
}

Matrix6d Stiffness(Random& random) {
  Matrix6d root;
  for (int k = 0; k < 36; ++k) root(k) = random.Uniform(-300, 300);
  return root * root.transpose();
}

TEST(AdjustBundle, EndsWhereNoSmallStepLowersTheCostOfPointsAndTies) {
  WorldProblem world = SmallWorld({1, 0, 0.3});
  Random random(2);
  BundleProblem& problem = world.problem;
  for (const auto& [from, to] : {std::pair<uint32_t, uint32_t>{0, 4}, {9, 3}, {2, 8}, {8, 9}, {0, 1}}) {
    const Rigid3 measured = RandomPose(random, 0.01, 0.02) * world.true_poses[to] * world.true_poses[from].Inverse();
    problem.ties.push_back({from, to, measured, Stiffness(random)});
  }
  BundleOptions options;
  options.second_rounds = 1, options.second_iterations = 60, options.relative_tolerance = 1e-14;
  const BundleResult result = AdjustBundle(problem, options);
  BundleProblem loose = problem;
  loose.ties.clear();
  EXPECT_GT(PoseDistance(AdjustBundle(loose, options).poses[9], result.poses[9]), 1e-4) << "ties pull";

  const double least = CostOf(problem, result);
  for (uint32_t pose = 0; pose < problem.poses.size(); ++pose) {
    if (problem.is_fixed[pose]) continue;
    for (int k = 0; k < 12; ++k) {
      BundleResult moved = result;
      moved.poses[pose] = Rigid3::FromStep((k < 6 ? 1e-4 : -1e-4) * Vector6d::Unit(k % 6)) * result.poses[pose];
      EXPECT_GT(CostOf(problem, moved), least) << pose << " " << k;
    }
  }
}

TEST(AdjustBundle, ATieHoldsAPoseThatItsPointsLeaveOpen) {
  WorldProblem world = SmallWorld({0, 0, 0});
  BundleProblem& problem = world.problem;
  // The last camera sees three points only, without depth.
  size_t num_left = 3;
  std::erase_if(problem.seen,
                [&](const BundleProblem::Seen& seen) { return seen.pose == 9 && (num_left == 0 || num_left-- == 0); });
  for (BundleProblem::Seen& seen : problem.seen) {
    if (seen.pose == 9) seen.observation.right_px = std::numeric_limits<double>::quiet_NaN();
  }
  const Rigid3 measured = world.true_poses[9] * world.true_poses[8].Inverse();
  problem.ties.push_back({8, 9, measured, 1e6 * Matrix6d::Identity()});
  ExpectTruth(world, AdjustBundle(problem, UntilSettled()));
}

}  // namespace
}  // namespace yorb

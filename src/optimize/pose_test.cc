// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/pose.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "optimize/ceres_oracle.h"
#include "optimize/test_problems.h"

namespace yorb {
namespace {

PoseEstimate Optimize(const PoseProblem& problem) {
  return OptimizePose(problem.guess, problem.observations, problem.projection);
}

void ExpectGuess(const PoseProblem& problem) {
  const PoseEstimate estimate = Optimize(problem);
  EXPECT_EQ(estimate.num_inliers, 0u);
  EXPECT_EQ(estimate.is_inlier, std::vector<bool>(problem.observations.size(), false));
  EXPECT_EQ(estimate.cam_from_world.translation, problem.guess.translation);
}

TEST(OptimizePose, RecoversTruthFromNoiseFreeObservations) {
  for (const double without_depth : {0.0, 0.5, 1.0}) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
      const PoseProblem problem = MakePoseProblem({0, 0, without_depth}, 50, seed);
      const PoseEstimate estimate = Optimize(problem);
      EXPECT_LT(PoseDistance(estimate.cam_from_world, problem.truth), 1e-8);
      EXPECT_LT(estimate.cost, 1e-12);
      EXPECT_EQ(estimate.num_inliers, 50u);
    }
  }
}

TEST(OptimizePose, RecoversTruthAmongAThirdOfOutliers) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const PoseProblem problem = MakePoseProblem({0, 0.33, 0.3}, 200, seed);
    const PoseEstimate estimate = Optimize(problem);
    EXPECT_LT(PoseDistance(estimate.cam_from_world, problem.truth), 1e-8);
    EXPECT_LT(estimate.num_inliers, 160u);
    EXPECT_GT(estimate.num_inliers, 110u);
  }
}

TEST(OptimizePose, ReachesTheCostOfCeresOnItsInliers) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    PoseProblem problem = MakePoseProblem({1, 0.3, 0.5}, 200, seed);
    Random random(seed);
    for (PoseObservation& o : problem.observations) o.weight = random.Uniform(0.2, 1);
    const PoseEstimate estimate = Optimize(problem);
    const CeresPoseResult oracle =
        CeresOptimizePose(problem.guess, problem.observations, estimate.is_inlier, problem.projection, 1e-14);
    EXPECT_NEAR(estimate.cost, oracle.cost, 1e-6 * oracle.cost);
    EXPECT_LT(PoseDistance(estimate.cam_from_world, oracle.cam_from_world), 1e-5);
  }
}

TEST(OptimizePose, SaysWhatItKnowsAsTheNumericJacobianDoes) {
  const PoseProblem problem = MakePoseProblem({1, 0, 0.5}, 100);
  const PoseEstimate estimate = Optimize(problem);
  const double h = 1e-6;
  Eigen::Matrix<double, 6, 6> numeric = Eigen::Matrix<double, 6, 6>::Zero();
  for (const PoseObservation& o : problem.observations) {
    Eigen::Matrix<double, 3, 6> jacobian;
    for (int i = 0; i < 6; ++i) {
      const Eigen::Matrix<double, 6, 1> step = h * Eigen::Matrix<double, 6, 1>::Unit(i);
      const auto error = [&](const Eigen::Matrix<double, 6, 1>& s) {
        return ErrorPx(Rigid3::FromStep(s) * estimate.cam_from_world * o.x_in_world, o.seen, problem.projection);
      };
      jacobian.col(i) = (error(step) - error(-step)) / (2 * h);
    }
    numeric += o.seen.inverse_variance * o.weight * jacobian.transpose() * jacobian;
  }
  ASSERT_EQ(estimate.num_inliers, problem.observations.size());
  EXPECT_LT((estimate.information - numeric).norm(), 1e-6 * numeric.norm());
}

/// Points that the camera at `truth` measures exactly on `num_planes` planes at right angles to each other.
std::vector<PlaneObservation> MakePlanes(const Rigid3& truth, int num_planes) {
  std::vector<PlaneObservation> planes;
  Random random(7);
  for (int plane = 0; plane < num_planes; ++plane) {
    const Eigen::Vector3d normal = Eigen::Vector3d::Unit(plane);
    for (int i = 0; i < 30; ++i) {
      Eigen::Vector3d x(random.Uniform(-2, 2), random.Uniform(-2, 2), random.Uniform(-2, 2));
      x[plane] = 2;
      planes.push_back({truth * x, normal, 2, 0.01, 1});
    }
  }
  return planes;
}

TEST(OptimizePose, ThreePlanesTellThePoseThatFewPointsLeaveOpen) {
  PoseProblem problem = MakePoseProblem({0, 0, 1}, 50);
  problem.observations.resize(3);
  for (PoseObservation& o : problem.observations) o.weight = 1e-9;  // counted, but silent
  const auto planes = MakePlanes(problem.truth, 3);
  const PoseEstimate estimate = OptimizePose(problem.guess, problem.observations, problem.projection, planes);
  EXPECT_LT(PoseDistance(estimate.cam_from_world, problem.truth), 1e-6);
}

TEST(OptimizePose, PlanesThatAgreeChangeNothing) {
  const PoseProblem problem = MakePoseProblem({0, 0, 0.5}, 50);
  const PoseEstimate estimate =
      OptimizePose(problem.guess, problem.observations, problem.projection, MakePlanes(problem.truth, 2));
  EXPECT_LT(PoseDistance(estimate.cam_from_world, problem.truth), 1e-8);
  EXPECT_LT((estimate.information - Optimize(problem).information).norm(), 1e-6 * estimate.information.norm());
}

TEST(OptimizePose, WrongPlanesAreOutvotedByHuber) {
  const PoseProblem problem = MakePoseProblem({0, 0, 0}, 200);
  auto planes = MakePlanes(problem.truth, 3);
  for (PlaneObservation& plane : planes) plane.weight = 1;
  for (size_t i = 0; i < planes.size(); i += 5) planes[i].offset += 1;
  const PoseEstimate estimate = OptimizePose(problem.guess, problem.observations, problem.projection, planes);
  EXPECT_LT(PoseDistance(estimate.cam_from_world, problem.truth), 0.005);
}

TEST(OptimizePose, SaysHowUnsureThePlaceIs) {
  const PoseProblem problem = MakePoseProblem({1, 0, 0}, 400);
  const double sigma = Optimize(problem).SigmaOfPlace();
  EXPECT_GT(sigma, 0);
  PoseProblem fewer = problem;
  fewer.observations.resize(100);
  EXPECT_NEAR(Optimize(fewer).SigmaOfPlace() / sigma, 2, 0.5);
  EXPECT_TRUE(std::isinf(PoseEstimate().SigmaOfPlace()));
}

TEST(OptimizePose, DoesNotDependOnTheOrder) {
  PoseProblem problem = MakePoseProblem({1, 0.3, 0.5}, 200);
  const PoseEstimate a = Optimize(problem);
  std::reverse(problem.observations.begin(), problem.observations.end());
  const PoseEstimate b = Optimize(problem);
  EXPECT_LT(PoseDistance(a.cam_from_world, b.cam_from_world), 1e-9);
  EXPECT_TRUE(std::equal(a.is_inlier.begin(), a.is_inlier.end(), b.is_inlier.rbegin()));
}

TEST(OptimizePose, FollowsTheWeights) {
  // Half the points have moved by 1.5 px: with little weight they pull little.
  PoseProblem problem = MakePoseProblem({0, 0, 0}, 200);
  for (size_t k = 0; k < 100; ++k) problem.observations[k].seen.x_px += 1.5;
  const double even = PoseDistance(Optimize(problem).cam_from_world, problem.truth);
  for (size_t k = 0; k < 100; ++k) problem.observations[k].weight = 0.01;
  const double weighted = PoseDistance(Optimize(problem).cam_from_world, problem.truth);
  for (size_t k = 0; k < 100; ++k) problem.observations[k].weight = 0;
  EXPECT_LT(weighted, 0.1 * even);
  EXPECT_LT(PoseDistance(Optimize(problem).cam_from_world, problem.truth), 1e-8);
}

TEST(OptimizePose, TakesPointsBehindTheCameraAndBrokenOnesAsOutliers) {
  PoseProblem problem = MakePoseProblem({0, 0, 0}, 60);
  auto& o = problem.observations;
  o[0].x_in_world = problem.truth.Inverse() * Eigen::Vector3d(0.1, 0.1, -2);
  o[1].x_in_world = problem.truth.Inverse() * Eigen::Vector3d(0, 0, 0);
  o[2].x_in_world.x() = kNan;
  o[3].seen.x_px = kNan;
  o[4].seen.inverse_variance = 0;
  o[5].seen.inverse_variance = kNan;
  o[6].weight = kNan;
  o[7].seen.right_px = std::numeric_limits<double>::infinity();
  const PoseEstimate estimate = Optimize(problem);
  EXPECT_LT(PoseDistance(estimate.cam_from_world, problem.truth), 1e-8);
  EXPECT_EQ(estimate.num_inliers, 52u);
  for (size_t k = 0; k < 8; ++k) EXPECT_FALSE(estimate.is_inlier[k]) << k;
  EXPECT_TRUE(estimate.information.allFinite());
}

TEST(OptimizePose, GivesTheGuessBackWhereTooLittleIsSeen) {
  for (const int count : {0, 1, 2}) ExpectGuess(MakePoseProblem({}, count));
  PoseProblem behind = MakePoseProblem({0, 0, 0}, 50);
  for (PoseObservation& o : behind.observations) {
    o.x_in_world = behind.guess.Inverse() * Eigen::Vector3d(0.1, 0.1, -1);
  }
  ExpectGuess(behind);
  PoseProblem unlike = MakePoseProblem({0, 0, 0}, 50);
  Random random(1);
  for (PoseObservation& o : unlike.observations) o.seen = {random.Uniform(0, 640), random.Uniform(0, 480), kNan, 100};
  const PoseEstimate estimate = Optimize(unlike);
  EXPECT_LT(estimate.num_inliers, 10u);
  EXPECT_TRUE(estimate.cam_from_world.IsFinite());
}

TEST(OptimizePose, StaysFiniteWhereThePoseIsNotDetermined) {
  PoseProblem line = MakePoseProblem({0, 0, 1}, 30);  // all points in one place, no depth
  for (PoseObservation& o : line.observations) o = line.observations[0];
  const PoseEstimate estimate = Optimize(line);
  EXPECT_TRUE(estimate.cam_from_world.IsFinite());
  EXPECT_EQ(estimate.num_inliers, 30u);
  PoseProblem lost = MakePoseProblem({0, 0, 0}, 30);
  lost.guess.translation.x() = kNan;
  EXPECT_EQ(Optimize(lost).num_inliers, 0u);
}

TEST(OptimizePose, WhatIsExpectedCountsByItsInformation) {
  const PoseProblem problem = MakePoseProblem({0, 0, 0.3}, 50);
  const Rigid3 elsewhere = Rigid3::FromStep(Vector6d::Constant(0.0005)) * problem.truth;
  const auto expecting = [&](double information) {
    const ExpectedPose expected{elsewhere, information * Matrix6d::Identity()};
    return OptimizePose(problem.guess, problem.observations, problem.projection, {}, expected).cam_from_world;
  };
  EXPECT_LT(PoseDistance(expecting(1e-3), problem.truth), 1e-6);
  EXPECT_LT(PoseDistance(expecting(1e12), elsewhere), 1e-6);
}

}  // namespace
}  // namespace yorb

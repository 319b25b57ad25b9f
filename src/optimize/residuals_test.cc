// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/residuals.h"

#include <gtest/gtest.h>

#include "optimize/test_problems.h"

namespace yorb {
namespace {

Eigen::Vector3d InFront(Random& random) { return Eigen::Vector3d(0, 0, 3) + InCube(random, 2); }

Observation Seen(Random& random, bool has_depth) {
  Observation seen{random.Uniform(0, 640), random.Uniform(0, 480), random.Uniform(0, 640), random.Uniform(0.1, 1)};
  if (!has_depth) seen.right_px = std::numeric_limits<double>::quiet_NaN();
  return seen;
}

TEST(ErrorJacobian, IsTheNumericDerivative) {
  Random random(1);
  const double h = 1e-6;
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector3d x = InFront(random);
    const Observation seen = Seen(random, k % 2 == 0);
    const Projection p = KinectProjection();
    const Eigen::Matrix3d analytic = ErrorJacobian(x, seen, p);
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
      const Eigen::Vector3d numeric = (ErrorPx(x + step, seen, p) - ErrorPx(x - step, seen, p)) / (2 * h);
      EXPECT_LT((analytic.col(i) - numeric).norm(), 1e-5 * (1 + analytic.norm()));
    }
  }
}

TEST(RobustLoss, HasTheWeightAsDerivativeAndNoJumps) {
  const double h = 1e-6;
  for (const bool use_huber : {false, true}) {
    for (const double s : {0.1, 5.0, 7.0, 8.0, 100.0, 9e5}) {
      const double numeric =
          (RobustLoss(s + h, 7.815, use_huber).cost - RobustLoss(s - h, 7.815, use_huber).cost) / (2 * h);
      EXPECT_NEAR(0.5 * RobustLoss(s, 7.815, use_huber).weight, numeric, 1e-4) << s;
    }
    for (const double s : {7.815, kCutSigmas * kCutSigmas}) {
      EXPECT_NEAR(RobustLoss(s - h, 7.815, use_huber).cost, RobustLoss(s + h, 7.815, use_huber).cost, 1e-5);
    }
  }
}

TEST(RobustLoss, OfWhatCannotBeSeenIsFiniteAndPullsAtNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Projection p = KinectProjection();
  for (const Eigen::Vector3d& x : {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(nan, 0, 1)}) {
    const Quadratic q = Linearize(x, Observation{1, 2, 3, 1}, 1, true, p);
    EXPECT_TRUE(std::isfinite(q.cost));
    EXPECT_GT(q.cost, RobustLoss(1e5, kChi2Stereo, true).cost);
    EXPECT_FALSE(q.has_pull);
  }
}

TEST(Linearize, HasTheNumericGradientAndGaussNewtonsHessian) {
  Random random(2);
  const double h = 1e-6;
  const Projection p = KinectProjection();
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector3d x = InFront(random);
    const Observation seen = Seen(random, k % 2 == 0);
    const bool use_huber = k % 3 == 0;
    const double weight = random.Uniform(0.1, 2);
    const Quadratic q = Linearize(x, seen, weight, use_huber, p);
    if (!q.has_pull) continue;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
      const double numeric = (Linearize(x + step, seen, weight, use_huber, p).cost -
                              Linearize(x - step, seen, weight, use_huber, p).cost) /
                             (2 * h);
      EXPECT_NEAR(q.gradient[i], numeric, 1e-5 * (1 + q.gradient.norm()));
    }
    const double w = RobustLoss(Chi2(x, seen, p), Chi2Bound(seen), use_huber).weight * weight * seen.inverse_variance;
    const Eigen::Matrix3d j = ErrorJacobian(x, seen, p);
    EXPECT_LT((q.hessian - w * j.transpose() * j).norm(), 1e-9 * q.hessian.norm());
  }
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/motion_model.h"

#include <gtest/gtest.h>

namespace yorb {
namespace {

Timestamp Ms(int64_t ms) { return {ms * 1000000}; }

TEST(MotionModel, AStepOfTwiceTheTimeIsTwiceAsLong) {
  MotionModel motion;
  const Rigid3 step(RotationFromVector({0, 0.02, 0}), Eigen::Vector3d(0.01, 0, 0));
  motion.Observe(Ms(0), Ms(33), step);
  const Rigid3 next = motion.Predict(Ms(33), Ms(66)), longer = motion.Predict(Ms(33), Ms(99));
  EXPECT_NEAR(next.translation.x(), 0.01, 1e-12);
  EXPECT_NEAR(longer.translation.x(), 0.02, 1e-12);
  EXPECT_NEAR(longer.RotationAngle(), 0.04, 1e-9);
}

TEST(MotionModel, KnowsNothingAfterAPause) {
  MotionModel motion;
  motion.Observe(Ms(0), Ms(33), Rigid3(Eigen::Quaterniond::Identity(), Eigen::Vector3d(1, 0, 0)));
  EXPECT_EQ(motion.Predict(Ms(33), Ms(3600000)).translation.norm(), 0);
  EXPECT_EQ(motion.Predict(Ms(33), Ms(33)).translation.norm(), 0);
  motion.Observe(Ms(33), Ms(5033), Rigid3(Eigen::Quaterniond::Identity(), Eigen::Vector3d(1, 0, 0)));
  EXPECT_EQ(motion.Predict(Ms(5033), Ms(5066)).translation.norm(), 0);
}

}  // namespace
}  // namespace yorb

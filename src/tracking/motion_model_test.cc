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

TEST(MotionModel, AStepShorterThanTheShutterTakesIsOneOfStamps) {
  MotionModel motion;
  EXPECT_FALSE(motion.RateWhileReading(0.026));
  const Rigid3 step(RotationFromVector({0, 0.02, 0}), Eigen::Vector3d(0.01, 0, 0));
  motion.Observe(Ms(0), Ms(33), step);
  EXPECT_EQ(motion.RateWhileReading(0.026)->shift_per_s, motion.rate()->shift_per_s);
  motion.Observe(Ms(33), Ms(34), step);  // handed over 1 ms after the last, and not taken then
  EXPECT_NEAR(motion.RateWhileReading(0.026)->shift_per_s.x(), 0.01 / 0.026, 1e-9);
  EXPECT_NEAR(motion.RateWhileReading(0.026)->turn_per_s.y(), 0.02 / 0.026, 1e-9);
  EXPECT_EQ(motion.RateWhileReading(0)->shift_per_s, motion.rate()->shift_per_s);
}

TEST(MotionModel, KnowsNothingAfterAPause) {
  MotionModel motion;
  motion.Observe(Ms(0), Ms(33), Rigid3(Eigen::Quaterniond::Identity(), Eigen::Vector3d(1, 0, 0)));
  EXPECT_EQ(motion.Predict(Ms(33), Ms(3600000)).translation.norm(), 0);
  EXPECT_EQ(motion.Predict(Ms(33), Ms(33)).translation.norm(), 0);
  motion.Observe(Ms(33), Ms(5033), Rigid3(Eigen::Quaterniond::Identity(), Eigen::Vector3d(1, 0, 0)));
  EXPECT_EQ(motion.Predict(Ms(5033), Ms(5066)).translation.norm(), 0);
}

Rigid3 Shift(double x) { return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0, 0)}; }

TEST(MotionModel, ACameraCannotJump) {
  MotionModel motion;
  EXPECT_TRUE(motion.CanReach(Ms(0), Ms(33), Shift(1))) << "nothing is known yet";
  motion.Observe(Ms(0), Ms(33), Shift(0.02));
  EXPECT_TRUE(motion.CanReach(Ms(33), Ms(66), Shift(0.02)));
  EXPECT_TRUE(motion.CanReach(Ms(33), Ms(66), Shift(0.04))) << "a jerk";
  EXPECT_FALSE(motion.CanReach(Ms(33), Ms(66), Shift(0.12)));
  EXPECT_FALSE(motion.CanReach(Ms(33), Ms(66), Rigid3(RotationFromVector({0, 0.2, 0}), Eigen::Vector3d(0.02, 0, 0))));
  EXPECT_TRUE(motion.CanReach(Ms(33), Ms(233), Shift(0.12))) << "as fast as before";
  EXPECT_TRUE(motion.CanReach(Ms(33), Ms(3033), Shift(5))) << "after a pause nothing is known";
}

TEST(MotionModel, AStepThatWasALittleOffMayBeMadeGood) {
  MotionModel motion;
  motion.Observe(Ms(0), Ms(33), Shift(0.02));
  motion.Observe(Ms(33), Ms(66), Shift(0.05));
  EXPECT_TRUE(motion.CanReach(Ms(66), Ms(99), Shift(-0.01)));
}

TEST(MotionModel, IsSteadyOnceTwoStepsAgree) {
  constexpr double kEase = 0.25;
  MotionModel motion;
  EXPECT_FALSE(motion.IsSteady(kEase)) << "nothing is known";
  motion.Observe(Ms(0), Ms(100), Shift(0.06));
  EXPECT_FALSE(motion.IsSteady(kEase)) << "one step may be anything";
  motion.Observe(Ms(100), Ms(200), Shift(0.05));
  EXPECT_TRUE(motion.IsSteady(kEase));
  motion.Observe(Ms(200), Ms(300), Shift(0.25));
  EXPECT_FALSE(motion.IsSteady(kEase)) << "more likely the step of someone else";
  motion.Observe(Ms(300), Ms(400), Rigid3(RotationFromVector({0, 0.2, 0}), Eigen::Vector3d(0.25, 0, 0)));
  EXPECT_FALSE(motion.IsSteady(kEase)) << "a sudden turn";
  motion.Observe(Ms(400), Ms(500), Rigid3(RotationFromVector({0, 0.2, 0}), Eigen::Vector3d(0.25, 0, 0)));
  EXPECT_TRUE(motion.IsSteady(kEase));
}

TEST(MotionModel, ExpectsWhatItPredictsAndIsLessSureOfItTheLongerItTakes) {
  MotionModel motion;
  EXPECT_FALSE(motion.Expect(Ms(0), Ms(100))) << "nothing is known";
  motion.Observe(Ms(0), Ms(100), Shift(0.06));
  const auto soon = motion.Expect(Ms(100), Ms(133)), later = motion.Expect(Ms(100), Ms(200));
  ASSERT_TRUE(soon && later);
  EXPECT_EQ(later->step.translation, motion.Predict(Ms(100), Ms(200)).translation);
  EXPECT_TRUE((soon->information.diagonal().array() > 2 * later->information.diagonal().array()).all());
  const double sigma_m = 1 / std::sqrt(later->information(5, 5));
  EXPECT_GT(sigma_m, 0.005);
  EXPECT_LT(sigma_m, 0.1) << "of a hand, in a tenth of a second";
  EXPECT_FALSE(motion.Expect(Ms(100), Ms(900))) << "after a pause";
}

}  // namespace
}  // namespace yorb

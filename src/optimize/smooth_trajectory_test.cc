// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/smooth_trajectory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "geometry/usual_motion.h"

namespace yorb {
namespace {

constexpr double kRate = 30;  // pictures a second
constexpr double kClaimed = 1e-3, kUnderstated = 4;

/// A camera that is swung by hand: two metres a second squared and four radians at most.
Rigid3 TruthAt(double seconds) {
  const Eigen::Vector3d centre(0.2 * std::sin(3 * seconds), 0.1 * std::sin(4 * seconds + 1),
                               0.15 * std::cos(2 * seconds));
  const Eigen::Vector3d turn(0.3 * std::sin(3 * seconds), 0.4 * std::cos(2 * seconds), 0.2 * std::sin(4 * seconds));
  const Eigen::Quaterniond rotation = RotationFromVector(turn);
  return {rotation, -(rotation * centre)};
}

Timestamp StampOf(double seconds) { return {static_cast<int64_t>(std::llround(seconds * 1e6)) * 1000}; }

Vector6d Noise(double sigma, Random& random) {
  return Vector6d::NullaryExpr([&](Eigen::Index) { return sigma * random.Gaussian(); });
}

/// Poses that err by four times what they claim.
std::vector<MeasuredPose> Measure(size_t size, double speed = 1) {
  Random random(7);
  std::vector<MeasuredPose> measured;
  for (size_t i = 0; i < size; ++i) {
    const double seconds = static_cast<double>(i) / kRate;
    const Rigid3 pose = Rigid3::FromStep(Noise(kUnderstated * kClaimed, random)) * TruthAt(speed * seconds);
    measured.push_back({StampOf(seconds), pose, Matrix6d::Identity() / (kClaimed * kClaimed)});
  }
  return measured;
}

std::vector<Rigid3> PosesOf(const std::vector<MeasuredPose>& measured) {
  std::vector<Rigid3> poses;
  for (const MeasuredPose& pose : measured) poses.push_back(pose.cam_from_world);
  return poses;
}

double Distance(const Rigid3& a, const Rigid3& b) { return (a.OriginInSource() - b.OriginInSource()).norm(); }

/// Root of the mean square of a distance to the truth.
template <typename Error>
double Rms(const std::vector<Rigid3>& poses, Error&& error, double speed = 1) {
  double sum = 0;
  for (size_t i = 0; i < poses.size(); ++i) {
    const double e = error(poses[i], TruthAt(speed * static_cast<double>(i) / kRate));
    sum += e * e;
  }
  return std::sqrt(sum / static_cast<double>(poses.size()));
}

double TurnBetween(const Rigid3& a, const Rigid3& b) { return (a * b.Inverse()).RotationAngle(); }

TEST(SmoothTrajectory, TakesTheTremblingOut) {
  const auto measured = Measure(300);
  const auto smooth = SmoothTrajectory(measured);
  ASSERT_EQ(smooth.size(), measured.size());
  EXPECT_LT(Rms(smooth, Distance), 0.75 * Rms(PosesOf(measured), Distance));
  EXPECT_LT(Rms(smooth, TurnBetween), 0.75 * Rms(PosesOf(measured), TurnBetween));
}

TEST(SmoothTrajectory, PosesBeforeAndAfterBridgeWhatNoPointHolds) {
  auto measured = Measure(90);
  for (size_t i = 40; i < 50; ++i) {
    measured[i].information.setZero();
    measured[i].cam_from_world.translation += 0.01 * static_cast<double>(i - 38) * Eigen::Vector3d::Ones();
  }
  const auto smooth = SmoothTrajectory(measured);
  for (size_t i = 40; i < 50; ++i) {
    EXPECT_LT(Distance(smooth[i], TruthAt(static_cast<double>(i) / kRate)), 0.02) << i;
  }
}

TEST(SmoothTrajectory, PiecesOnBothSidesOfAPauseKnowNothingOfOneAnother) {
  auto measured = Measure(80);
  for (size_t i = 40; i < 80; ++i) measured[i].timestamp.ns += 400'000'000;
  const auto both = SmoothTrajectory(measured);
  const auto first = SmoothTrajectory({measured.begin(), measured.begin() + 40});
  for (size_t i = 0; i < first.size(); ++i) EXPECT_EQ(Distance(both[i], first[i]), 0);
}

TEST(SmoothTrajectory, ALeapOfTheMapStaysWhereItIs) {
  auto measured = Measure(120);
  const auto before = SmoothTrajectory(measured);
  for (size_t i = 60; i < 120; ++i) measured[i].cam_from_world.translation += Eigen::Vector3d(1, 0, 0);
  const auto smooth = SmoothTrajectory(measured);
  for (size_t i = 0; i < 45; ++i) EXPECT_LT(Distance(smooth[i], before[i]), 0.002) << i;
  for (size_t i = 75; i < 120; ++i) {
    EXPECT_LT(Distance(smooth[i], measured[i].cam_from_world), Distance(before[i], measured[i].cam_from_world) + 0.02);
  }
}

TEST(SmoothTrajectory, KeepsToWhatWasMeasuredWhereStampsAreWrongOrTheCameraIsQuick) {
  constexpr double kTooShort = 1000;  // milliseconds that were taken for microseconds, say
  auto measured = Measure(300);
  for (MeasuredPose& pose : measured) pose.timestamp.ns /= static_cast<int64_t>(kTooShort);
  const auto smooth = SmoothTrajectory(measured);
  EXPECT_LT(Rms(smooth, Distance), 1.5 * Rms(PosesOf(measured), Distance));

  constexpr double kQuick = 5;
  const auto quick = Measure(300, kQuick);
  EXPECT_LT(Rms(SmoothTrajectory(quick), Distance, kQuick), 1.5 * Rms(PosesOf(quick), Distance, kQuick));
}

TEST(SmoothTrajectory, TakesWhatIsHardlyAPath) {
  EXPECT_TRUE(SmoothTrajectory({}).empty());
  for (const size_t size : {1u, 2u}) {
    const auto measured = Measure(size);
    const auto smooth = SmoothTrajectory(measured);
    ASSERT_EQ(smooth.size(), size);
    for (size_t i = 0; i < size; ++i) EXPECT_EQ(Distance(smooth[i], measured[i].cam_from_world), 0);
  }
  auto at_once = Measure(20);
  for (size_t i = 5; i < 9; ++i) at_once[i].timestamp = at_once[4].timestamp;
  std::swap(at_once[12].timestamp, at_once[13].timestamp);
  for (MeasuredPose& pose : at_once) pose.information.setZero();
  for (const Rigid3& pose : SmoothTrajectory(at_once)) EXPECT_TRUE(pose.IsFinite());
}

/// What the poses of a path cost, written down without a derivative.
double Cost(const std::vector<MeasuredPose>& measured, const std::vector<Rigid3>& poses) {
  double cost = 0;
  for (size_t i = 0; i < poses.size(); ++i) {
    const Rigid3 off = poses[i] * measured[i].cam_from_world.Inverse();
    const double variance = std::pow(kUnderstated * kClaimed, 2);
    cost += (VectorFromRotation(off.rotation).squaredNorm() + off.translation.squaredNorm()) / variance;
  }
  for (size_t i = 1; i + 1 < poses.size(); ++i) {
    const Rigid3 first = poses[i] * poses[i - 1].Inverse(), second = poses[i + 1] * poses[i].Inverse();
    const Eigen::Vector3d turn = VectorFromRotation(second.rotation) - VectorFromRotation(first.rotation);
    const Eigen::Vector3d shift =
        poses[i + 1].OriginInSource() - 2 * poses[i].OriginInSource() + poses[i - 1].OriginInSource();
    const double per_s2 = kRate * kRate;
    cost +=
        (turn * per_s2 / kUsualTurnAcceleration).squaredNorm() + (shift * per_s2 / kUsualAcceleration).squaredNorm();
  }
  return cost;
}

TEST(SmoothTrajectory, NoPoseAloneCouldBeLikelier) {
  auto measured = Measure(30);
  for (size_t i = 0; i < measured.size(); ++i) {
    measured[i].timestamp.ns = static_cast<int64_t>(i) * 33'333'000;  // equal steps, as Cost has them
  }
  const auto smooth = SmoothTrajectory(measured);
  const double least = Cost(measured, smooth);
  EXPECT_LT(least, Cost(measured, PosesOf(measured)));
  Random random(3);
  for (size_t i = 0; i < smooth.size(); ++i) {
    for (int k = 0; k < 10; ++k) {
      auto other = smooth;
      other[i] = Rigid3::FromStep(Noise(1e-3, random)) * other[i];
      EXPECT_GT(Cost(measured, other), least) << i;
    }
  }
}

}  // namespace
}  // namespace yorb

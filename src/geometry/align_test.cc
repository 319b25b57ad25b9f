// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/align.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

namespace yorb {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Eigen::Vector3d RandomVector(Random& random) {
  const double x = random.Gaussian(), y = random.Gaussian(), z = random.Gaussian();
  return {x, y, z};
}

Alignment RandomTruth(Random& random, double scale) {
  Alignment truth;
  truth.rotation = RotationFromVector(2.0 * RandomVector(random));
  truth.translation = 5.0 * RandomVector(random);
  truth.scale = scale;
  return truth;
}

Points Moved(const Alignment& motion, const Points& points) {
  Points moved;
  for (const auto& point : points) moved.push_back(motion * point);
  return moved;
}

double SumOfSquares(const Alignment& motion, const Points& source, const Points& target) {
  double sum = 0;
  for (size_t i = 0; i < source.size(); ++i) sum += (target[i] - motion * source[i]).squaredNorm();
  return sum;
}

Points Cloud(Random& random, size_t count) {
  Points points;
  for (size_t i = 0; i < count; ++i) points.push_back(RandomVector(random));
  return points;
}

TEST(Align, FindsTheExactMotionAndScale) {
  Random random(1);
  for (const AlignMode mode : {AlignMode::kRigid, AlignMode::kSimilarity}) {
    for (int trial = 0; trial < 20; ++trial) {
      const Alignment truth = RandomTruth(random, mode == AlignMode::kRigid ? 1.0 : random.Uniform(0.01, 50));
      const Points source = Cloud(random, 3 + random.Below(30));
      const Alignment found = AlignPoints(source, Moved(truth, source), mode);
      EXPECT_LT(found.rotation.angularDistance(truth.rotation), 1e-6);
      EXPECT_NEAR(found.scale, truth.scale, 1e-9 * truth.scale);
      EXPECT_LT((found.translation - truth.translation).norm(), 1e-7);
      EXPECT_EQ(found.degeneracy, AlignDegeneracy::kNone);
    }
  }
}

TEST(Align, NoNeighbouringMotionFitsNoisyPointsBetter) {
  Random random(2);
  for (const AlignMode mode : {AlignMode::kRigid, AlignMode::kSimilarity}) {
    const Points source = Cloud(random, 40);
    Points target = Moved(RandomTruth(random, 1.7), source);
    for (auto& point : target) point += 0.1 * RandomVector(random);
    const Alignment found = AlignPoints(source, target, mode);
    const double best = SumOfSquares(found, source, target);
    for (int trial = 0; trial < 200; ++trial) {
      Alignment other = found;
      other.rotation = RotationFromVector(1e-3 * RandomVector(random)) * found.rotation;
      other.translation += 1e-3 * RandomVector(random);
      if (mode == AlignMode::kSimilarity) other.scale *= 1 + 1e-3 * random.Gaussian();
      EXPECT_GE(SumOfSquares(other, source, target), best);
    }
  }
}

TEST(Align, NeverMirrors) {
  Random random(3);
  Points source = Cloud(random, 30), target = source;
  for (auto& point : target) point.x() = -point.x();
  const Alignment found = AlignPoints(source, target, AlignMode::kRigid);
  EXPECT_NEAR(found.rotation.toRotationMatrix().determinant(), 1.0, 1e-9);
  EXPECT_GT(SumOfSquares(found, source, target), 1.0);
}

TEST(Align, PointsInAPlaneAreEnough) {
  Random random(4);
  Points source = Cloud(random, 20);
  for (auto& point : source) point.z() = 2;
  const Alignment truth = RandomTruth(random, 1);
  const Alignment found = AlignPoints(source, Moved(truth, source), AlignMode::kRigid);
  EXPECT_EQ(found.degeneracy, AlignDegeneracy::kNone);
  EXPECT_LT(found.rotation.angularDistance(truth.rotation), 1e-6);
}

TEST(Align, ALineIsNamedAndItsResidualIsRight) {
  Random random(5);
  Points source, target;
  const Alignment truth = RandomTruth(random, 1);
  double residual = 0;
  for (int i = 0; i < 50; ++i) {
    source.emplace_back(0.1 * i, 0, 0);
    target.push_back(truth * Eigen::Vector3d(0.1 * i + (i % 2 == 0 ? 0.01 : -0.01), 0, 0));
  }
  const Alignment found = AlignPoints(source, target, AlignMode::kRigid);
  EXPECT_EQ(found.degeneracy, AlignDegeneracy::kLine);
  residual = std::sqrt(SumOfSquares(found, source, target) / 50);
  EXPECT_NEAR(residual, 0.01, 1e-5);
}

TEST(Align, AMapFarFromTheOriginMovesAsItDoesNearIt) {
  const Eigen::Vector3d northing(5e5, 1e7, 100);  // UTM on the southern hemisphere
  Points source, target;
  for (int i = 0; i < 90; ++i) {
    source.emplace_back(0.001 * i, 0.002 * std::sin(0.1 * i), 0.001 * std::cos(0.2 * i));
    target.push_back(source.back() + northing);
  }
  const Alignment found = AlignPoints(source, target, AlignMode::kRigid);
  EXPECT_EQ(found.degeneracy, AlignDegeneracy::kNone);
  EXPECT_LT(SumOfSquares(found, source, target), 1e-12);
}

TEST(Align, OnePlaceIsNamedAndLeavesTheSpread) {
  Points moving, still;
  for (int i = 0; i < 90; ++i) {
    moving.emplace_back(0.05 * i, 0.01 * i * i, 0);
    still.emplace_back(1, 2, 3);
  }
  for (const AlignMode mode : {AlignMode::kRigid, AlignMode::kSimilarity}) {
    const Alignment onto_moving = AlignPoints(still, moving, mode), onto_still = AlignPoints(moving, still, mode);
    EXPECT_EQ(onto_moving.degeneracy, AlignDegeneracy::kOnePlace);
    EXPECT_EQ(onto_still.degeneracy, AlignDegeneracy::kOnePlace);
    EXPECT_EQ(onto_still.scale, 1.0) << "a scale of 0 would hide every error";
    EXPECT_NEAR(SumOfSquares(onto_moving, still, moving), SumOfSquares(onto_still, moving, still), 1e-6);
    EXPECT_GT(SumOfSquares(onto_still, moving, still), 1.0);
  }
}

TEST(Align, FewPointsAreNamedAndGiveFiniteMotions) {
  Random random(6);
  for (size_t count = 0; count < 3; ++count) {
    const Points source = Cloud(random, count), target = Cloud(random, count);
    const Alignment found = AlignPoints(source, target, AlignMode::kSimilarity);
    EXPECT_EQ(found.degeneracy, AlignDegeneracy::kTooFew);
    EXPECT_TRUE(found.rotation.coeffs().allFinite() && found.translation.allFinite() && std::isfinite(found.scale));
  }
}

TEST(Align, PosesMoveLikeTheirPositions) {
  Random random(7);
  const Alignment motion = RandomTruth(random, 2.5);
  const Rigid3 pose(RotationFromVector(RandomVector(random)), RandomVector(random));
  const Rigid3 moved = motion * pose;
  EXPECT_LT((moved.translation - motion * pose.translation).norm(), 1e-12);
  EXPECT_LT(moved.rotation.angularDistance(motion.rotation * pose.rotation), 1e-7);
}

}  // namespace
}  // namespace yorb

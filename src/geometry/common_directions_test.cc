// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/common_directions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "geometry/rigid3.h"

namespace yorb {
namespace {

Eigen::Vector3d AnyDirection(Random& random) {
  return Eigen::Vector3d(random.Gaussian(), random.Gaussian(), random.Gaussian()).normalized();
}

/// The planes in which lines of one direction are seen from anywhere, each up to `off` radians wrong.
void AddLines(const Eigen::Vector3d& direction, int count, double off, Random& random, std::vector<LinePlane>& planes) {
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d along = RotationFromVector(random.Uniform(0, off) * AnyDirection(random)) * direction;
    planes.push_back({along.cross(AnyDirection(random)).normalized().cast<float>(), 1});
  }
}

void AddClutter(int count, Random& random, std::vector<LinePlane>& planes) {
  for (int k = 0; k < count; ++k) planes.push_back({AnyDirection(random).cast<float>(), 1});
}

double AngleDeg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * 180 / M_PI;
}

TEST(CommonDirections, OfARoomAreFoundAmongClutter) {
  Random random(3);
  const Eigen::Quaterniond turned = RotationFromVector({0.4, -0.2, 0.7});
  const std::vector<Eigen::Vector3d> truth = {turned * Eigen::Vector3d::UnitY(), turned * Eigen::Vector3d::UnitX(),
                                              turned * Eigen::Vector3d(0.5, 0, 1).normalized()};
  std::vector<LinePlane> planes;
  AddLines(truth[0], 900, 0.02, random, planes);
  AddLines(truth[1], 600, 0.02, random, planes);
  AddLines(truth[2], 500, 0.02, random, planes);
  AddClutter(1000, random, planes);
  const auto found = CommonDirections(planes);
  ASSERT_EQ(found.size(), 3u);
  for (size_t k = 0; k < 3; ++k) EXPECT_LT(AngleDeg(found[k], truth[k]), 0.2) << "the commonest first, " << k;
}

TEST(CommonDirections, OfClutterThereAreNone) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    std::vector<LinePlane> planes;
    AddClutter(500, random, planes);
    EXPECT_TRUE(CommonDirections(planes).empty()) << seed;
  }
}

TEST(CommonDirections, OnePlaneSeenAgainAndAgainTellsNone) {
  Random random(5);
  std::vector<LinePlane> planes;
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector3d normal = Eigen::Vector3d::UnitX() + 0.03 * AnyDirection(random);
    planes.push_back({normal.normalized().cast<float>(), 1});
  }
  EXPECT_TRUE(CommonDirections(planes).empty()) << "any direction in that plane would do";
}

TEST(CommonDirections, TakeWeightsForWhatTheyAre) {
  Random random(7);
  std::vector<LinePlane> planes;
  AddLines(Eigen::Vector3d::UnitX(), 50, 0, random, planes);
  for (LinePlane& plane : planes) plane.weight = 20;
  AddLines(Eigen::Vector3d::UnitZ(), 500, 0, random, planes);
  const auto found = CommonDirections(planes);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT(AngleDeg(found[0], Eigen::Vector3d::UnitX()), 0.1);
  EXPECT_LT(AngleDeg(found[1], Eigen::Vector3d::UnitZ()), 0.1);
}

TEST(CommonDirections, NeedLines) {
  EXPECT_TRUE(CommonDirections({}).empty());
  EXPECT_TRUE(CommonDirections({{Eigen::Vector3f::UnitX(), 1}}).empty());
  EXPECT_TRUE(CommonDirections({{Eigen::Vector3f::UnitX(), 1}, {Eigen::Vector3f::UnitX(), 1}}).empty());
  EXPECT_TRUE(CommonDirections({{Eigen::Vector3f::UnitX(), 0}, {Eigen::Vector3f::UnitY(), 0}}).empty());
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/pnp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "geometry/test_poses.h"

namespace yorb {
namespace {

using Triple = std::array<Eigen::Vector3d, 3>;

Eigen::Vector3d InPicture(Random& random) {
  const double z = random.Uniform(0.5, 6);
  return {random.Uniform(-0.6, 0.6) * z, random.Uniform(-0.45, 0.45) * z, z};
}

struct Scene {
  Rigid3 truth;
  std::vector<PnpObservation> observations;
};

constexpr double kPixel = 1.0 / 525;

/// Points seen with one pixel of noise; the first `num_wrong` are somewhere else.
Scene MakeScene(size_t count, size_t num_wrong, Random& random) {
  Scene scene{RandomPose(random, 2, 3), {}};
  for (size_t k = 0; k < count; ++k) {
    const Eigen::Vector3d x_in_cam = InPicture(random);
    const Eigen::Vector3d seen = k < num_wrong ? InPicture(random) : x_in_cam;
    const Eigen::Vector2d noise(random.Gaussian(), random.Gaussian());
    scene.observations.push_back({scene.truth.Inverse() * x_in_cam, seen.hnormalized() + kPixel * noise, kPixel});
  }
  return scene;
}

TEST(SolveP3p, FindsTheTruePoseOfRandomTriples) {
  Random random(7);
  std::vector<double> errors;
  for (int k = 0; k < 10000; ++k) {
    const Rigid3 truth = RandomPose(random, 2, 3);
    Triple directions, points;
    for (size_t i = 0; i < 3; ++i) {
      directions[i] = InPicture(random);
      points[i] = truth.Inverse() * directions[i];
    }
    const std::vector<Rigid3> poses = SolveP3p(directions, points);
    ASSERT_LE(poses.size(), 4u);
    double error = std::numeric_limits<double>::infinity();
    for (const Rigid3& pose : poses) error = std::min(error, PoseDistance(pose, truth));
    errors.push_back(error);
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 1e-13);
  EXPECT_LT(errors.back(), 1e-6);
}

TEST(SolveP3p, EveryPoseThatItGivesSeesThePointsInTheDirections) {
  Random random(8);
  size_t num_poses = 0;
  for (int k = 0; k < 2000; ++k) {
    const Triple directions = {InPicture(random), InPicture(random), InPicture(random)};
    const Triple points = {InCube(random, 2), InCube(random, 2), InCube(random, 2)};
    for (const Rigid3& pose : SolveP3p(directions, points)) {
      ++num_poses;
      for (size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d x_in_cam = pose * points[i];
        EXPECT_GT(x_in_cam.dot(directions[i]), 0);
        EXPECT_LT(x_in_cam.normalized().cross(directions[i].normalized()).norm(), 1e-6);
      }
    }
  }
  EXPECT_GT(num_poses, 1000u);
}

TEST(SolveP3p, FindsTheTruePoseOfSymmetricTriples) {
  const double h = std::sqrt(0.75);
  for (const double z : {0.7, 1.0, 2.0, 10.0}) {
    const Triple points = {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-0.5, h, 0), Eigen::Vector3d(-0.5, -h, 0)};
    const Rigid3 truth(Eigen::Quaterniond::Identity(), {0, 0, z});
    const Triple directions = {truth * points[0], truth * points[1], truth * points[2]};
    double error = std::numeric_limits<double>::infinity();
    for (const Rigid3& pose : SolveP3p(directions, points)) error = std::min(error, PoseDistance(pose, truth));
    EXPECT_LT(error, 1e-6) << z;
  }
}

TEST(SolveP3p, GivesNothingForDegenerateInput) {
  const Triple directions = {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.3, 0, 1), Eigen::Vector3d(0, 0.2, 1)};
  const Eigen::Vector3d a(0, 0, 2), b(1, 0, 2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(SolveP3p(directions, {a, b, 0.5 * (a + b)}).empty()) << "points on a line";
  EXPECT_TRUE(SolveP3p(directions, {a, a, b}).empty()) << "a point twice";
  EXPECT_TRUE(SolveP3p(directions, {a, a, a}).empty());
  EXPECT_TRUE(SolveP3p(directions, {a, b, Eigen::Vector3d(0, nan, 1)}).empty());
  EXPECT_TRUE(
      SolveP3p({directions[0], directions[1], Eigen::Vector3d(nan, 0, 1)}, {a, b, Eigen::Vector3d(0, 1, 2)}).empty());
  EXPECT_TRUE(SolveP3p({directions[0], directions[0], directions[0]}, {a, b, Eigen::Vector3d(0, 1, 2)}).empty())
      << "one direction for three points";
}

TEST(PnpRansac, FindsThePoseAmongHalfWrongObservations) {
  Random random(9);
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = MakeScene(200, 100, random);
    const auto result = PnpRansac(scene.observations, {}, Random(seed));
    ASSERT_TRUE(result);
    EXPECT_LT(PoseDistance(result->cam_from_world, scene.truth), 0.05);
    EXPECT_GT(result->num_inliers, 60u);
    EXPECT_EQ(result->num_inliers,
              static_cast<size_t>(std::count(result->is_inlier.begin(), result->is_inlier.end(), true)));
    EXPECT_LT(std::count(result->is_inlier.begin(), result->is_inlier.begin() + 100, true), 5);
    EXPECT_LT(result->iterations, PnpOptions().ransac.max_iterations);
  }
}

TEST(PnpRansac, IsTheSameForTheSameSeedAndStopsEarlyWithoutOutliers) {
  Random random(10);
  const Scene scene = MakeScene(100, 0, random);
  const auto a = PnpRansac(scene.observations, {}, Random(1)), b = PnpRansac(scene.observations, {}, Random(1));
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->cam_from_world.translation, b->cam_from_world.translation);
  EXPECT_EQ(a->is_inlier, b->is_inlier);
  EXPECT_LT(a->iterations, 60);
}

TEST(PnpRansac, ScalesItsBoundByEachDeviation) {
  Random random(11);
  Scene scene = MakeScene(100, 0, random);
  // The first half is off by 8 pixels and says so, the second half is off by 8 pixels and does not.
  for (size_t k = 0; k < 60; ++k) {
    scene.observations[k].point_on_plane.x() += 8 * kPixel;
    if (k < 30) scene.observations[k].deviation = 8 * kPixel;
  }
  const auto result = PnpRansac(scene.observations, {}, Random(3));
  ASSERT_TRUE(result);
  EXPECT_GT(std::count(result->is_inlier.begin(), result->is_inlier.begin() + 30, true), 25);
  EXPECT_LT(std::count(result->is_inlier.begin() + 30, result->is_inlier.begin() + 60, true), 5);
}

TEST(PnpRansac, GivesNothingWhereNothingAgrees) {
  Random random(12);
  EXPECT_FALSE(PnpRansac({}, {}, Random(1)));
  EXPECT_FALSE(PnpRansac(MakeScene(2, 0, random).observations, {}, Random(1)));
  EXPECT_FALSE(PnpRansac(MakeScene(100, 100, random).observations, {}, Random(1)));
  const std::vector<PnpObservation> equal(50, PnpObservation{{0, 0, 1}, {0, 0}, kPixel});
  EXPECT_FALSE(PnpRansac(equal, {}, Random(1)));
  Scene scene = MakeScene(50, 0, random);
  for (PnpObservation& o : scene.observations) o.x_in_world.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(PnpRansac(scene.observations, {}, Random(1)));
}

TEST(DrawSample, HasNoNumberTwiceAndReachesAll) {
  Random random(13);
  std::array<int, 5> counts{};
  for (int k = 0; k < 1000; ++k) {
    const auto sample = DrawSample<3>(5, random);
    EXPECT_TRUE(sample[0] != sample[1] && sample[0] != sample[2] && sample[1] != sample[2]);
    for (const uint32_t i : sample) ++counts[i];
  }
  for (const int count : counts) EXPECT_NEAR(count, 600, 80);
}

TEST(SamplesNeeded, FollowsTheFormula) {
  EXPECT_EQ(SamplesNeeded(1, 3, 0.99), 1);
  EXPECT_NEAR(SamplesNeeded(0.5, 3, 0.99), std::log(0.01) / std::log(1 - 0.125), 1e-9);
  EXPECT_TRUE(std::isinf(SamplesNeeded(0, 3, 0.99)));
}

}  // namespace
}  // namespace yorb

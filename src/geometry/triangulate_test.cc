// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/triangulate.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/random.h"
#include "geometry/test_poses.h"

namespace yorb {
namespace {

View ViewOf(const Rigid3& cam_from_world, const Eigen::Vector3d& x_in_world) {
  return {cam_from_world, (cam_from_world * x_in_world).hnormalized()};
}

Rigid3 CameraAt(const Eigen::Vector3d& centre, const Eigen::Vector3d& rotation) {
  const Eigen::Quaterniond q = RotationFromVector(rotation);
  return {q, -(q * centre)};
}

/// Views from about the origin, far from which `shift` is added to everything.
std::vector<View> RandomViews(int count, const Eigen::Vector3d& x, const Eigen::Vector3d& shift, Random& random) {
  std::vector<View> views;
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d centre = Eigen::Vector3d(0.3 * k, 0, 0) + InCube(random, 0.1);
    views.push_back(ViewOf(CameraAt(centre + shift, InCube(random, 0.3)), x + shift));
  }
  return views;
}

TEST(Triangulate, FindsThePointThatTwoOrMoreViewsSee) {
  Random random(1);
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector3d shift = InCube(random, 1000);
    const Eigen::Vector3d x = Eigen::Vector3d(0, 0, 3) + InCube(random, 1);
    const std::vector<View> views = RandomViews(2 + k % 5, x, shift, random);
    const auto many = Triangulate(views), two = Triangulate(views[0], views[1]);
    ASSERT_TRUE(many && two);
    EXPECT_LT((*many - x - shift).norm(), 1e-9);
    EXPECT_LT((*two - x - shift).norm(), 1e-9);
  }
}

TEST(Triangulate, ErrsByAboutTheNoiseAndLessWithMoreViews) {
  Random random(2);
  double two_squared = 0, ten_squared = 0;
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector3d x = Eigen::Vector3d(1, 0, 3) + InCube(random, 0.5);
    std::vector<View> views = RandomViews(10, x, {0, 0, 0}, random);
    for (View& view : views) view.point_on_plane += Eigen::Vector2d(random.Gaussian(), random.Gaussian()) / 525;
    const auto ten = Triangulate(views), two = Triangulate(views[0], views[3]);
    ASSERT_TRUE(ten && two);
    ten_squared += (*ten - x).squaredNorm() / 300;
    two_squared += (*two - x).squaredNorm() / 300;
  }
  // Depth from two views 0.9 m apart at 3 m: z^2 / baseline * sqrt(2) / focal = 0.027 m.
  EXPECT_LT(std::sqrt(two_squared), 0.04);
  EXPECT_LT(std::sqrt(ten_squared), 0.5 * std::sqrt(two_squared));
}

TEST(Triangulate, RefusesRaysThatAreNearlyParallel) {
  const Eigen::Vector3d x(0, 0, 10);
  const View a = ViewOf(CameraAt({0, 0, 0}, {0, 0, 0}), x);
  const View near = ViewOf(CameraAt({0.1, 0, 0}, {0, 0, 0}), x), far = ViewOf(CameraAt({0.4, 0, 0}, {0, 0, 0}), x);
  EXPECT_FALSE(Triangulate(a, near)) << "0.6 degrees";
  EXPECT_TRUE(Triangulate(a, near, 0.99999));
  EXPECT_TRUE(Triangulate(a, far)) << "2.3 degrees";
  EXPECT_FALSE(Triangulate(a, a));
  EXPECT_TRUE(Triangulate({a, near, far})) << "the widest pair counts";
}

TEST(Triangulate, RefusesPointsBehindACamera) {
  const Eigen::Vector3d x(0, 0, 2);
  const Rigid3 left = CameraAt({0, 0, 0}, {0, 0, 0}), right = CameraAt({1, 0, 0}, {0, 0, 0});
  EXPECT_TRUE(Triangulate(ViewOf(left, x), ViewOf(right, x)));
  // Rays that diverge meet behind both.
  EXPECT_FALSE(Triangulate(View{left, {-0.3, 0}}, View{right, {0.3, 0}}));
  // A camera that looks the other way sees the mirrored direction.
  EXPECT_FALSE(Triangulate(ViewOf(left, x), ViewOf(CameraAt({1, 0, 0}, {0, M_PI, 0}), x)));
}

TEST(Triangulate, GivesNothingForTooFewViewsOrNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d x(0, 0, 2);
  const View a = ViewOf(CameraAt({0, 0, 0}, {0, 0, 0}), x), b = ViewOf(CameraAt({1, 0, 0}, {0, 0, 0}), x);
  EXPECT_FALSE(Triangulate(std::vector<View>{}));
  EXPECT_FALSE(Triangulate({a}));
  EXPECT_FALSE(Triangulate(a, View{b.cam_from_world, {nan, 0}}));
  EXPECT_FALSE(Triangulate({a, b, View{b.cam_from_world, {0, nan}}}));
  Rigid3 broken = b.cam_from_world;
  broken.translation.x() = nan;
  EXPECT_FALSE(Triangulate(a, View{broken, {0, 0}}));
}

TEST(ParallaxCosine, OfRaysAndOfCentresAgree) {
  Random random(3);
  for (int k = 0; k < 100; ++k) {
    const Eigen::Vector3d x = Eigen::Vector3d(0, 0, 3) + InCube(random, 1);
    const std::vector<View> v = RandomViews(2, x, {0, 0, 0}, random);
    EXPECT_NEAR(ParallaxCosine(v[0], v[1]),
                ParallaxCosine(x, v[0].cam_from_world.OriginInSource(), v[1].cam_from_world.OriginInSource()), 1e-12);
  }
  EXPECT_EQ(ParallaxCosine({1, 2, 3}, {1, 2, 3}, {0, 0, 0}), 1);
}

}  // namespace
}  // namespace yorb

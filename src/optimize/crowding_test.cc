// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/crowding.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "optimize/test_problems.h"

namespace yorb {
namespace {

Rig RigOf(const Projection& projection) {
  Rig rig;
  rig.camera.fx = projection.fx, rig.camera.fy = projection.fy;
  rig.camera.cx = projection.cx, rig.camera.cy = projection.cy;
  rig.camera.width = 640, rig.camera.height = 480;
  return rig;
}

double SumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(SharesOfPlaces, FewPointsCountInFullWhereverTheyAre) {
  const Rig rig = RigOf(KinectProjection());
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<Eigen::Vector2f> points = {{10, 10}, {300, 200}, {310, 201}, {639, 479}, {-25, 700}, {inf, -inf}};
  EXPECT_EQ(SharesOfPlaces(points, rig), std::vector<double>(points.size(), 1));
  EXPECT_TRUE(SharesOfPlaces({}, rig).empty());
}

TEST(SharesOfPlaces, APlaceCountsNoMoreForHavingMorePoints) {
  const Rig rig = RigOf(KinectProjection());
  const auto crowd = [&](size_t count) {
    std::vector<Eigen::Vector2f> points(count, Eigen::Vector2f(100, 100));
    points.emplace_back(500, 400);
    const std::vector<double> shares = SharesOfPlaces(points, rig);
    EXPECT_EQ(shares.back(), 1) << "the crowd is elsewhere";
    return SumOf(shares) - 1;
  };
  EXPECT_EQ(crowd(2), 2);
  EXPECT_NEAR(crowd(100), crowd(10), 1e-9);
  EXPECT_LT(crowd(100), 5);
}

TEST(SharesOfPlaces, AreKnownForCamerasThatDoNotStateTheirSize) {
  Rig rig = RigOf(KinectProjection());
  rig.camera.width = rig.camera.height = 0;
  EXPECT_NEAR(SumOf(SharesOfPlaces(std::vector<Eigen::Vector2f>(50, Eigen::Vector2f(100, 100)), rig)), 3, 1e-9);
}

TEST(SharesOfPlaces, AShirtFullOfPointsDoesNotOutvoteTheRoom) {
  PoseProblem problem = MakePoseProblem({0.5, 0, 0.3}, 60);
  Random random(2);
  const Rigid3 shirt_moved(Eigen::Quaterniond::Identity(), {0.03, 0.01, 0});  // with somebody, since it was mapped
  for (int k = 0; k < 90; ++k) {
    const Eigen::Vector3d x_in_cam(random.Uniform(0.2, 0.35), random.Uniform(0, 0.15), 2);
    const Observation seen = Observe(shirt_moved * x_in_cam, problem.projection, {0.5, 0, 0.3}, random);
    problem.observations.push_back({problem.truth.Inverse() * x_in_cam, seen, 1});
  }
  problem.guess = problem.truth;
  const auto off = [&] {
    return PoseDistance(OptimizePose(problem.guess, problem.observations, problem.projection).cam_from_world,
                        problem.truth);
  };
  EXPECT_GT(off(), 0.02) << "it does where each point counts the same";
  std::vector<Eigen::Vector2f> points;
  for (const PoseObservation& o : problem.observations)
    points.push_back(Eigen::Vector2d(o.seen.x_px, o.seen.y_px).cast<float>());
  const std::vector<double> shares = SharesOfPlaces(points, RigOf(problem.projection));
  for (size_t k = 0; k < shares.size(); ++k) problem.observations[k].weight = shares[k];
  EXPECT_LT(off(), 0.005);
}

}  // namespace
}  // namespace yorb

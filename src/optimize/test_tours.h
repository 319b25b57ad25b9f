// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "optimize/test_problems.h"

// Large bundle problems with known truth for the tests and benchmarks of this room.
namespace yorb {

struct TourOptions {
  Noise noise;
  uint32_t poses = 500, points = 50000, rounds = 2;
  double spacing = 0.4;      ///< metres between neighbouring poses of a round
  double share_seen = 0.64;  ///< of what is in the picture
  double pose_error = 0.02, point_error = 0.05;
  uint64_t seed = 1;
};

/// A camera walks round a large hall, some times, and looks at its wall two metres away; the first pose is fixed. What
/// is seen in one round is seen again in the others, so that far rows of the reduced system are tied together.
inline WorldProblem MakeTour(const TourOptions& options) {
  Random random(options.seed);
  WorldProblem world;
  BundleProblem& problem = world.problem;
  problem.projection = KinectProjection();
  const double turn = 2 * M_PI * options.rounds / options.poses;
  const double radius = options.spacing / turn, wall = radius + 2;
  for (uint32_t k = 0; k < options.poses; ++k) {
    const Rigid3 standing(RotationFromVector({0, turn * k, 0}),
                          {radius * std::sin(turn * k), 0, radius * std::cos(turn * k)});
    world.true_poses.push_back(RandomPose(random, 0.1, 0.1) * standing.Inverse());
    problem.is_fixed.push_back(k == 0);
    const Rigid3 error = RandomPose(random, options.pose_error, options.pose_error);
    problem.poses.push_back(k == 0 ? world.true_poses[k] : error * world.true_poses[k]);
  }
  for (uint32_t point = 0; point < options.points; ++point) {
    const double angle = random.Uniform(0, 2 * M_PI), distance = wall + random.Uniform(-0.5, 0.5);
    const Eigen::Vector3d x_in_world(distance * std::sin(angle), random.Uniform(-1, 1), distance * std::cos(angle));
    world.true_points.push_back(x_in_world);
    problem.points.push_back(x_in_world + InCube(random, options.point_error));
    for (uint32_t pose = 0; pose < options.poses; ++pose) {
      const Eigen::Vector3d x = world.true_poses[pose] * x_in_world;
      if (x.z() < 0.3 || x.z() > 5) continue;
      const Eigen::Vector3d px = ErrorPx(x, Observation{0, 0, 0, 1}, problem.projection);
      if (px.x() < 0 || px.x() > 640 || px.y() < 0 || px.y() > 480) continue;
      if (random.Uniform() > options.share_seen) continue;
      problem.seen.push_back({pose, point, Observe(x, problem.projection, options.noise, random)});
    }
  }
  return world;
}

}  // namespace yorb

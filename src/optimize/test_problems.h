// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/random.h"
#include "geometry/test_poses.h"
#include "optimize/bundle.h"
#include "optimize/pose.h"
#include "optimize/residuals.h"

// Problems with known truth for the tests and benchmarks of this room.
namespace yorb {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

inline Projection KinectProjection() {
  Projection p;
  p.fx = 525, p.fy = 520, p.cx = 320, p.cy = 240, p.baseline_px = 40;
  return p;
}

/// Where a point is seen, with uniform noise of the given half width; a fraction is far off; a fraction has no depth.
struct Noise {
  double noise_px = 1;
  double outliers = 0;
  double without_depth = 0;
};

inline Observation Observe(const Eigen::Vector3d& x_in_cam, const Projection& p, const Noise& noise, Random& random) {
  Eigen::Vector3d px = ErrorPx(x_in_cam, Observation{0, 0, 0, 1}, p) + InCube(random, noise.noise_px);
  if (random.Uniform() < noise.outliers) px += Eigen::Vector3d(30, -20, 25) + InCube(random, 10);
  Observation seen{px.x(), px.y(), px.z(), 1};
  if (random.Uniform() < noise.without_depth) seen.right_px = std::numeric_limits<double>::quiet_NaN();
  return seen;
}

struct PoseProblem {
  Projection projection = KinectProjection();
  Rigid3 truth, guess;
  std::vector<PoseObservation> observations;
};

/// `count` points in a picture and a guess that is a little off.
inline PoseProblem MakePoseProblem(const Noise& noise, int count = 300, uint64_t seed = 1) {
  Random random(seed);
  PoseProblem problem;
  problem.truth = {RotationFromVector(InCube(random, 1)), InCube(random, 1)};
  problem.guess = RandomPose(random, 0.03, 0.05) * problem.truth;
  for (int k = 0; k < count; ++k) {
    const double z = random.Uniform(0.8, 5);
    const Eigen::Vector3d x_in_cam(random.Uniform(-0.6, 0.6) * z, random.Uniform(-0.45, 0.45) * z, z);
    PoseObservation o{problem.truth.Inverse() * x_in_cam, Observe(x_in_cam, problem.projection, noise, random), 1};
    problem.observations.push_back(o);
  }
  return problem;
}

struct WorldProblem {
  BundleProblem problem;  ///< perturbed
  std::vector<Rigid3> true_poses;
  std::vector<Eigen::Vector3d> true_points;
};

struct WorldOptions {
  Noise noise;
  uint32_t poses = 20, points = 2000, fixed = 2;
  double range = 3;  ///< metres between the ends of the camera's path
  double pose_error = 0.02, point_error = 0.05;
  uint64_t seed = 1;
};

/// A camera moves sideways along a wall with depth, looking ahead.
inline WorldProblem MakeWorld(const WorldOptions& options) {
  Random random(options.seed);
  WorldProblem world;
  BundleProblem& problem = world.problem;
  problem.projection = KinectProjection();
  const double step = options.poses > 1 ? options.range / (options.poses - 1) : 0;
  for (uint32_t k = 0; k < options.poses; ++k) {
    const Eigen::Vector3d centre = Eigen::Vector3d(step * k, 0, 0) + InCube(random, 0.1);
    const Eigen::Quaterniond rotation = RotationFromVector(InCube(random, 0.1));
    world.true_poses.push_back({rotation, -(rotation * centre)});
    problem.is_fixed.push_back(k < options.fixed);
  }
  for (uint32_t k = 0; k < options.points; ++k) {
    world.true_points.push_back(
        {random.Uniform(-1.0, options.range + 1.0), random.Uniform(-1, 1), random.Uniform(1.5, 2.5)});
  }
  for (uint32_t pose = 0; pose < options.poses; ++pose) {
    for (uint32_t point = 0; point < options.points; ++point) {
      const Eigen::Vector3d x = world.true_poses[pose] * world.true_points[point];
      const Eigen::Vector3d px = ErrorPx(x, Observation{0, 0, 0, 1}, problem.projection);
      if (px.x() < 0 || px.x() > 640 || px.y() < 0 || px.y() > 480) continue;
      problem.seen.push_back({pose, point, Observe(x, problem.projection, options.noise, random)});
    }
  }
  for (uint32_t k = 0; k < options.poses; ++k) {
    const Rigid3 error = RandomPose(random, options.pose_error, options.pose_error);
    problem.poses.push_back(problem.is_fixed[k] ? world.true_poses[k] : error * world.true_poses[k]);
  }
  for (const Eigen::Vector3d& x : world.true_points) problem.points.push_back(x + InCube(random, options.point_error));
  return world;
}

}  // namespace yorb

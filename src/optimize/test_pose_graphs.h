// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "optimize/pose_graph.h"
#include "optimize/test_problems.h"

// Pose graphs with known truth for the tests and benchmarks of this room.
namespace yorb {

struct CircleOptions {
  uint32_t poses = 100;     ///< the first is fixed
  uint32_t neighbours = 1;  ///< the following poses that each is tied to, as covisible keyframes are
  double radius = 5;        ///< metres
  double drift = 0;         ///< of each measured motion: radians, and metres
  double noise = 0;         ///< the same, of random sign
  double start_drift = 0;   ///< of the first guess alone, per pose
  uint64_t seed = 1;
};

struct CircleGraph {
  PoseGraph graph;
  std::vector<Rigid3> truth;
};

/// A camera that looks along its way round a circle and comes home: motions between poses, and one true tie between the
/// last pose and the first. The first guess is what the motions from pose to pose add up to.
inline CircleGraph MakeCircle(const CircleOptions& options) {
  Random random(options.seed);
  CircleGraph circle;
  PoseGraph& graph = circle.graph;
  for (uint32_t k = 0; k < options.poses; ++k) {
    const double angle = 2.0 * M_PI * k / options.poses;
    const Rigid3 world_from_cam(RotationFromVector({0, angle, 0.1 * std::sin(3 * angle)}),
                                {options.radius * std::cos(angle), 0.2 * angle, -options.radius * std::sin(angle)});
    circle.truth.push_back(world_from_cam.Inverse());
    graph.is_fixed.push_back(k == 0);
  }
  const Rigid3 drift = Rigid3::FromStep(Eigen::Matrix<double, 6, 1>::Constant(options.drift));
  const auto measured = [&](uint32_t from, uint32_t to) {
    return RandomPose(random, options.noise, options.noise) * drift * circle.truth[to] * circle.truth[from].Inverse();
  };
  const Rigid3 start_drift = Rigid3::FromStep(Eigen::Matrix<double, 6, 1>::Constant(options.start_drift));
  graph.poses.push_back(circle.truth.front());
  for (uint32_t k = 0; k + 1 < options.poses; ++k) {
    for (uint32_t to = k + 1; to <= k + options.neighbours && to < options.poses; ++to) {
      graph.edges.push_back({k, to, measured(k, to), 1.0 / (to - k)});
      if (to == k + 1) graph.poses.push_back(start_drift * graph.edges.back().to_from_from * graph.poses[k]);
    }
  }
  const uint32_t last = options.poses - 1;
  graph.edges.push_back({last, 0, circle.truth[0] * circle.truth[last].Inverse(), 100});
  return circle;
}

/// How far the camera stands from where it should, at most.
inline double GreatestError(const std::vector<Rigid3>& poses, const std::vector<Rigid3>& truth) {
  double greatest = 0;
  for (size_t k = 0; k < poses.size(); ++k) {
    greatest = std::max(greatest, (poses[k].OriginInSource() - truth[k].OriginInSource()).norm());
  }
  return greatest;
}

}  // namespace yorb

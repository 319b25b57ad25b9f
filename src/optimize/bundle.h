// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/rigid3.h"
#include "optimize/observation.h"

namespace yorb {

/// Poses, points and who sees what; a value, independent of any map.
struct BundleProblem {
  struct Seen {
    uint32_t pose = 0, point = 0;  ///< rows of `poses` and `points`
    Observation observation;
  };
  /// What else is known of two poses: `poses[to] = FromStep(error) * to_from_from * poses[from]`, and the cost is half
  /// of error^T * information * error.
  struct Tie {
    uint32_t from = 0, to = 0;
    Rigid3 to_from_from;
    Matrix6d information;
  };
  /// A straight edge that a pose sees, and the direction in the world in which it is thought to run. The cost is half
  /// of log(1 + error^2), Cauchy's, for error = normal_in_cam . rotation * direction_in_world / sigma: some run
  /// otherwise.
  struct Line {
    uint32_t pose = 0;
    Eigen::Vector3d normal_in_cam, direction_in_world;
    double sigma = 0;
  };
  Projection projection;
  std::vector<Rigid3> poses;   ///< cam_from_world
  std::vector<bool> is_fixed;  ///< a row a pose; at least one is fixed, or the problem floats
  std::vector<Eigen::Vector3d> points;
  std::vector<Seen> seen;
  std::vector<Tie> ties;
  std::vector<Line> lines;
};

struct BundleOptions {
  int first_iterations = 5;          ///< with Huber's loss, before outliers are taken out
  int second_iterations = 10;        ///< without outliers, Huber off; all rounds of it together
  int second_rounds = 1;             ///< after each of which outliers are judged anew, until their set stays
  double relative_tolerance = 1e-6;  ///< a round ends when a step lowers the cost by less than this fraction
};

struct BundleResult {
  std::vector<Rigid3> poses;
  std::vector<Eigen::Vector3d> points;
  std::vector<bool> is_outlier;  ///< a row an entry of `seen`: chi-square above 95 % at the end, or behind the camera
  double initial_cost = 0, final_cost = 0;
  int iterations = 0;
  bool was_stopped = false;  ///< `should_stop` said so; the values are the best so far
};

/// Bundle adjustment: Levenberg-Marquardt on the Schur complement of the points; the reduced system is dense for a
/// neighbourhood, sparse for a map. `should_stop` is asked before every iteration (new keyframes wait); it may be
/// empty.
BundleResult AdjustBundle(const BundleProblem& problem, const BundleOptions& options,
                          const std::function<bool()>& should_stop = {});

}  // namespace yorb

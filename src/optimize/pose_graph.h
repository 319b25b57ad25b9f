// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/rigid3.h"

namespace yorb {

/// Poses and what was measured between them; a value, independent of any map.
struct PoseGraph {
  struct Edge {
    uint32_t from = 0, to = 0;  ///< rows of `poses`
    Rigid3 to_from_from;        ///< measured
    double weight = 1;          ///< multiplies the cost
    bool is_robust = false;     ///< Huber's loss, for edges that may be wrong (a loop)
  };
  std::vector<Rigid3> poses;   ///< cam_from_world
  std::vector<bool> is_fixed;  ///< a row a pose; at least one of what hangs together is fixed, or it floats
  std::vector<Edge> edges;
};

struct PoseGraphOptions {
  /// Standard deviations of an edge of weight 1. What counts is their ratio: an error of the rotation shifts what is
  /// seen two metres away by as much as one of the translation.
  double rotation_sigma_rad = 0.0025, translation_sigma = 0.005;
  double huber_sigmas = 3;  ///< where the loss of robust edges turns linear
  int max_iterations = 30;
  double relative_tolerance = 1e-6;  ///< it ends when a step lowers the cost by less than this fraction
};

struct PoseGraphResult {
  std::vector<Rigid3> poses;
  double initial_cost = 0, final_cost = 0;  ///< half the weighted (robust) chi-square
  int iterations = 0;
  bool was_stopped = false;  ///< `should_stop` said so; the poses are the best so far
};

/// Poses that agree best with all edges: Levenberg-Marquardt on a sparse system. Fixed poses and poses without edges
/// stay to the bit. Edges that are not finite, of no weight, or from a pose to itself do not count. `should_stop` is
/// asked before every iteration and may be empty.
PoseGraphResult AdjustPoseGraph(const PoseGraph& graph, const PoseGraphOptions& options = {},
                                const std::function<bool()>& should_stop = {});

}  // namespace yorb

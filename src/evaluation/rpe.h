// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/stats.h"
#include "geometry/trajectory.h"

namespace yorb {

/// What the distance between the two poses of a pair is counted in.
enum class RpeUnit { kSeconds, kMetres, kFrames };

/// How relative pose errors are taken.
struct RpeOptions {
  double delta = 1;  ///< finite and > 0
  RpeUnit unit = RpeUnit::kSeconds;
  double scale = 1;   ///< of the estimate, from its Sim(3) alignment
  double offset = 0;  ///< seconds, added to the estimate's stamps
};

/// The relative pose error, by the rules of TUM's evaluate_rpe.py with --fixed_delta: each pose of the estimate pairs
/// with the one nearest to `delta` later (seconds, metres along the estimate's scaled path, or rows); pairs that end on
/// the last pose are dropped; each end takes the nearest true pose, and the pair is dropped where that is farther than
/// twice the truth's median interval.
struct RelativeError {
  std::vector<double> translation;  ///< metres, one a pair
  std::vector<double> rotation_deg;
  Summary translation_summary, rotation_summary;
  size_t num_odd = 0;  ///< pairs less than half or more than twice `delta` apart, at gaps of the estimate
};

/// Both trajectories rise strictly in time.
RelativeError ComputeRelativeError(const Trajectory& reference, const Trajectory& estimate, const RpeOptions& options);

}  // namespace yorb

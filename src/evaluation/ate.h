// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/stats.h"
#include "evaluation/associate.h"
#include "geometry/align.h"
#include "geometry/trajectory.h"

namespace yorb {

constexpr size_t kLeastPairsToAlign = 3;  ///< of positions, for an alignment

/// How the estimate is brought to the reference before the error is taken.
enum class EvalAlign { kSe3, kSim3, kNone };

/// The absolute trajectory error: how far each estimated position is from the true one.
struct AbsoluteError {
  Alignment reference_from_estimate;  ///< identity for kNone
  std::vector<double> errors;         ///< metres, one a pair
  Summary summary;
};

/// Aligns the paired positions and measures what remains.
AbsoluteError ComputeAbsoluteError(const Trajectory& reference, const Trajectory& estimate,
                                   const std::vector<StampPair>& pairs, EvalAlign align);

/// The stamps of a trajectory.
std::vector<Timestamp> StampsOf(const Trajectory& trajectory);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"
#include "geometry/trajectory.h"

namespace yorb {

/// The text forms of a trajectory.
enum class TrajectoryFormat {
  kAuto,   ///< TUM's eight numbers, or what an unmistakable header says; anything else is refused
  kTum,    ///< timestamp tx ty tz qx qy qz qw
  kKitti,  ///< a 3x4 matrix a row, or 4x4 with 0 0 0 1 at its end, no time stamps: row k stands at k seconds
  kEuroc,  ///< CSV: nanoseconds, position, quaternion with w first; further columns are passed over
};

/// A trajectory as it was read.
struct ReadTrajectory {
  std::string path;
  Trajectory poses;                   ///< stamps rise strictly
  bool has_stamps = true;             ///< false: rows are numbered (KITTI)
  std::vector<std::string> warnings;  ///< a line each
};

/// Reads a trajectory. Blanks, tabs or commas part the numbers; quaternions are normalised; of poses with one stamp the
/// last counts (a warning says how many). Bad input, by file and line: another number of columns, a number that is none
/// or not finite, a zero quaternion, a matrix that is no rotation, a cut last line, a stamp that goes back; no poses.
Result<ReadTrajectory> ReadTrajectoryFile(const std::string& path, TrajectoryFormat format = TrajectoryFormat::kAuto);

}  // namespace yorb

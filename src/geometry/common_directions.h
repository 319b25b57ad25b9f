// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace yorb {

/// A plane through a camera's centre in which a line of the world lies, seen in one frame for all cameras.
struct LinePlane {
  Eigen::Vector3f normal;  ///< length 1, either sign
  float weight = 1;
};

/// How far from a common direction a line may run and still count as one of it, as the sine of that angle.
constexpr float kParallel = 0.026f;  // 1.5 degrees

/// The directions that much of what is seen runs in, the commonest first: up, along and across in a room, a table's
/// edges on a desk. A line of direction d lies in a plane whose normal is at right angles to d (its image passes
/// through d's vanishing point). Each direction has at least a tenth of the weight, which lines that run anyhow would
/// not give to any (they give 2.6 %), and planes that are different enough to tell it.
std::vector<Eigen::Vector3d> CommonDirections(const std::vector<LinePlane>& planes);

}  // namespace yorb

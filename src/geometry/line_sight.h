// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace yorb {

/// A straight line of the world as one picture shows it: somewhere in a plane through the camera's centre. Where the
/// camera stands does not matter to which way the line runs.
struct LineSight {
  Eigen::Vector3f normal;  ///< of that plane, in the camera frame; length 1, either sign
  float sigma = 0;         ///< of normal . direction, for the direction in which the line is thought to run
};

/// What one picture shows of them, shared and never copied; null where nobody looked.
using LineSightsPtr = std::shared_ptr<const std::vector<LineSight>>;

}  // namespace yorb

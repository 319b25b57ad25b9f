// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests and benchmarks of this room and of those that build on it.
#pragma once

#include "core/random.h"
#include "geometry/rigid3.h"

namespace yorb {

/// Uniform in a cube of the given half side.
inline Eigen::Vector3d InCube(Random& random, double half_side) {
  return {random.Uniform(-half_side, half_side), random.Uniform(-half_side, half_side),
          random.Uniform(-half_side, half_side)};
}

/// A rotation vector and a translation, each uniform in a cube of so many radians and metres of half side.
inline Rigid3 RandomPose(Random& random, double radians, double metres) {
  return {RotationFromVector(InCube(random, radians)), InCube(random, metres)};
}

/// How far two poses are from each other: metres and radians in one sum.
inline double PoseDistance(const Rigid3& a, const Rigid3& b) {
  const Rigid3 difference = a * b.Inverse();
  return difference.translation.norm() + difference.RotationAngle();
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/rigid3.h"
#include "optimize/reduced_system.h"

namespace yorb {

/// The inverse of Rigid3::FromStep: rotation vector, then translation.
inline Vector6d StepFrom(const Rigid3& motion) {
  Vector6d step;
  step << VectorFromRotation(motion.rotation), motion.translation;
  return step;
}

/// How far two poses are from what was measured between them: `to_from_from^-1 * to * from^-1` as a step, in the frame
/// of `from`.
inline Vector6d RelativePoseError(const Rigid3& from, const Rigid3& to, const Rigid3& to_from_from) {
  return StepFrom(to_from_from.Inverse() * (to * from.Inverse()));
}

/// The derivative of VectorFromRotation(exp(w) * exp(v)) by w at w = 0: the inverse of SO(3)'s left Jacobian at v. That
/// of exp(v) * exp(w) is its transpose.
inline Eigen::Matrix3d InverseLeftJacobian(const Eigen::Vector3d& v) {
  const double angle = v.norm(), half = 0.5 * angle;
  // (1 - half * cot(half)) / angle^2, by its series where the quotient would lose digits.
  const double c = angle < 1e-3 ? 1.0 / 12.0 + angle * angle / 720.0
                                : (1.0 - half * std::cos(half) / std::sin(half)) / (angle * angle);
  const Eigen::Matrix3d skew = Skew(v);
  return Eigen::Matrix3d::Identity() - 0.5 * skew + c * skew * skew;
}

/// RelativePoseError and its derivatives by steps of both poses (`pose = FromStep(step) * pose`).
struct RelativePoseJacobians {
  Vector6d error;
  Matrix6d by_from, by_to;
};

inline RelativePoseJacobians LinearizeRelativePose(const Rigid3& from, const Rigid3& to, const Rigid3& to_from_from) {
  const Rigid3 moved = to * from.Inverse();  // as the poses have it
  const Rigid3 difference = to_from_from.Inverse() * moved;
  const Eigen::Matrix3d back = to_from_from.rotation.conjugate().toRotationMatrix();
  RelativePoseJacobians j;
  j.error = StepFrom(difference);
  const Eigen::Matrix3d inverse_left = InverseLeftJacobian(j.error.head<3>());
  j.by_to << inverse_left * back, Eigen::Matrix3d::Zero(), -back * Skew(moved.translation), back;
  j.by_from << -inverse_left.transpose(), Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(),
      -difference.rotation.toRotationMatrix();
  return j;
}

}  // namespace yorb

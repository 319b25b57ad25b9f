// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: geometry. Rigid motions and what can be computed from points and rays alone.
// Takes: points, rays, correspondences. Gives: motions and points by value. Owns: nothing.
// Runs on: whichever thread calls. May not: know pictures, maps or files.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace yorb {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// A rotation followed by a translation: `x_in_b = b_from_a * x_in_a`.
struct Rigid3 {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< always of unit length
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Rigid3() = default;
  Rigid3(const Eigen::Quaterniond& r, const Eigen::Vector3d& t) : rotation(r.normalized()), translation(t) {}
  Rigid3(const Eigen::Matrix3d& r, const Eigen::Vector3d& t) : Rigid3(Eigen::Quaterniond(r), t) {}

  static Rigid3 Identity() { return {}; }

  /// The exponential map of (rotation vector, translation): the step that optimisers apply from the left,
  /// `pose = Rigid3::FromStep(step) * pose`. The translation is taken as it is (SO(3) x R3), which is a good
  /// retraction and has the simpler Jacobian.
  static Rigid3 FromStep(const Eigen::Matrix<double, 6, 1>& step);

  Rigid3 Inverse() const {
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, -(back * translation)};
  }

  /// The origin of `b` seen from `a`: for `cam_from_world`, the camera's centre in the world.
  Eigen::Vector3d OriginInSource() const { return -(rotation.conjugate() * translation); }

  double RotationAngle() const { return 2.0 * std::atan2(rotation.vec().norm(), std::abs(rotation.w())); }

  bool IsFinite() const { return rotation.coeffs().allFinite() && translation.allFinite(); }
};

inline Rigid3 operator*(const Rigid3& c_from_b, const Rigid3& b_from_a) {
  return {c_from_b.rotation * b_from_a.rotation, c_from_b.rotation * b_from_a.translation + c_from_b.translation};
}

inline Eigen::Vector3d operator*(const Rigid3& b_from_a, const Eigen::Vector3d& x_in_a) {
  return b_from_a.rotation * x_in_a + b_from_a.translation;
}

/// The rotation by |v| radians about v.
Eigen::Quaterniond RotationFromVector(const Eigen::Vector3d& v);

/// The inverse of RotationFromVector, of length at most pi.
Eigen::Vector3d VectorFromRotation(const Eigen::Quaterniond& q);

/// The matrix with `Skew(a) * b == a x b`.
inline Eigen::Matrix3d Skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace yorb

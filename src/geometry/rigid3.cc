// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/rigid3.h"

#include <cmath>

namespace yorb {

Rigid3 Rigid3::FromStep(const Eigen::Matrix<double, 6, 1>& step) {
  return {RotationFromVector(step.head<3>()), step.tail<3>()};
}

Eigen::Quaterniond RotationFromVector(const Eigen::Vector3d& v) {
  const double angle = v.norm();
  // sin(x/2)/x, by its series where the quotient would lose digits.
  const double scale = angle < 1e-6 ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  Eigen::Quaterniond q;
  q.w() = std::cos(0.5 * angle);
  q.vec() = scale * v;
  return q.normalized();
}

Eigen::Vector3d VectorFromRotation(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0 ? -1.0 : 1.0;
  const double sine = q.vec().norm();
  const double angle = 2.0 * std::atan2(sine, std::abs(q.w()));
  const double scale = sine < 1e-9 ? 2.0 : angle / sine;
  return sign * scale * q.vec();
}

}  // namespace yorb

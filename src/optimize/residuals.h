// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "geometry/rigid3.h"
#include "optimize/observation.h"

namespace yorb {

/// Nearer than this to the plane through the camera's centre (metres), a point counts as not in front of it.
constexpr double kMinDepth = 1e-3;

/// Where the loss is cut off: an observation this many standard deviations off, or of a point that is not in front of
/// the camera, costs as much as one at the cut and pulls at nothing. So every cost is finite and comparable.
constexpr double kCutSigmas = 1000;

/// Predicted minus seen, in pixels: x, y, and x in the virtual right picture (0 where there is no depth).
inline Eigen::Vector3d ErrorPx(const Eigen::Vector3d& x_in_cam, const Observation& seen, const Projection& p) {
  const double inverse_z = 1.0 / x_in_cam.z();
  const double x_px = p.fx * x_in_cam.x() * inverse_z + p.cx;
  const double y_px = p.fy * x_in_cam.y() * inverse_z + p.cy;
  const double right_px = seen.HasDepth() ? x_px - p.baseline_px * inverse_z - seen.right_px : 0.0;
  return {x_px - seen.x_px, y_px - seen.y_px, right_px};
}

/// The derivative of ErrorPx by the point in the camera frame; the last row is 0 where there is no depth.
inline Eigen::Matrix3d ErrorJacobian(const Eigen::Vector3d& x_in_cam, const Observation& seen, const Projection& p) {
  const double inverse_z = 1.0 / x_in_cam.z();
  const double x_by_x = p.fx * inverse_z, x_by_z = -x_by_x * x_in_cam.x() * inverse_z;
  const double y_by_y = p.fy * inverse_z, y_by_z = -y_by_y * x_in_cam.y() * inverse_z;
  const double has_depth = seen.HasDepth() ? 1.0 : 0.0;
  Eigen::Matrix3d jacobian;
  jacobian << x_by_x, 0, x_by_z, 0, y_by_y, y_by_z, has_depth * x_by_x, 0,
      has_depth * (x_by_z + p.baseline_px * inverse_z * inverse_z);
  return jacobian;
}

/// The 95 % bound of an observation's chi-square.
inline double Chi2Bound(const Observation& seen) { return seen.HasDepth() ? kChi2Stereo : kChi2Mono; }

/// The squared error over its variance; infinite where the point is not in front of the camera or anything is not
/// finite.
inline double Chi2(const Eigen::Vector3d& x_in_cam, const Observation& seen, const Projection& p) {
  if (!(x_in_cam.z() > kMinDepth)) return std::numeric_limits<double>::infinity();
  const double chi2 = seen.inverse_variance * ErrorPx(x_in_cam, seen, p).squaredNorm();
  return chi2 >= 0 ? chi2 : std::numeric_limits<double>::infinity();
}

/// A loss and its derivative by the chi-square.
struct Loss {
  double cost = 0;
  double weight = 0;
};

/// Half the chi-square, or half of Huber's loss of it, cut at kCutSigmas.
inline Loss RobustLoss(double chi2, double bound, bool use_huber) {
  constexpr double kCut = kCutSigmas * kCutSigmas;
  const bool is_cut = !(chi2 < kCut);
  const double s = is_cut ? kCut : chi2;
  if (!use_huber || s <= bound) return {0.5 * s, is_cut ? 0.0 : 1.0};
  const double root = std::sqrt(bound * s);
  return {root - 0.5 * bound, is_cut ? 0.0 : bound / root};
}

/// The cost of one observation near the present values, as a function of a small shift of the point in the camera
/// frame: cost + gradient . shift + 1/2 shift . hessian . shift (Gauss-Newton). What a step of the pose or of the point
/// does to that shift, `x_in_cam += [-Skew(x_in_cam) | I] * step` and `x_in_cam += R * step`, is the caller's to
/// multiply in: this way the 3x3 core is shared and the wide Jacobians are never formed.
struct Quadratic {
  double cost = 0;
  bool has_pull = false;  ///< false: gradient and hessian are zero and not set
  Eigen::Vector3d gradient;
  Eigen::Matrix3d hessian;  ///< symmetric, all of it set
};

/// The quadratic of one observation with `weight` times the (robust) loss.
inline Quadratic Linearize(const Eigen::Vector3d& x_in_cam, const Observation& seen, double weight, bool use_huber,
                           const Projection& p) {
  Quadratic q;
  const Loss loss = RobustLoss(Chi2(x_in_cam, seen, p), Chi2Bound(seen), use_huber);
  q.cost = weight * loss.cost;
  const double w = weight * loss.weight * seen.inverse_variance;
  q.has_pull = w > 0;
  if (!q.has_pull) return q;
  const Eigen::Vector3d error = ErrorPx(x_in_cam, seen, p);
  const Eigen::Matrix3d j = ErrorJacobian(x_in_cam, seen, p);
  q.gradient.noalias() = j.transpose() * (w * error);
  const double xx = w * (j(0, 0) * j(0, 0) + j(2, 0) * j(2, 0)), yy = w * j(1, 1) * j(1, 1);
  const double xz = w * (j(0, 0) * j(0, 2) + j(2, 0) * j(2, 2)), yz = w * j(1, 1) * j(1, 2);
  const double zz = w * (j(0, 2) * j(0, 2) + j(1, 2) * j(1, 2) + j(2, 2) * j(2, 2));
  q.hessian << xx, 0, xz, 0, yy, yz, xz, yz, zz;
  return q;
}

/// `Skew(a) * m`, column by column.
inline Eigen::Matrix3d CrossColumns(const Eigen::Vector3d& a, const Eigen::Matrix3d& m) {
  Eigen::Matrix3d result;
  for (int k = 0; k < 3; ++k) result.col(k) = a.cross(m.col(k));
  return result;
}

}  // namespace yorb

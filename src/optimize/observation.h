// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: optimize. Poses and points that make the errors in the pictures least.
// Takes: plain arrays of poses, points and observations, or a map snapshot. Gives: values that the caller applies.
// Owns: nothing. Runs on: whichever thread calls. May not: change a map, know files; Ceres only in tests and benches.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "camera/rig.h"

namespace yorb {

/// The constants of the projection; ideal pixels.
struct Projection {
  double fx = 0, fy = 0, cx = 0, cy = 0;
  double baseline_px = 0;  ///< right_px = x_px - baseline_px / z

  Projection() = default;
  explicit Projection(const Rig& rig)
      : fx(rig.camera.fx),
        fy(rig.camera.fy),
        cx(rig.camera.cx),
        cy(rig.camera.cy),
        baseline_px(rig.VirtualBaselinePx()) {}
};

/// Where a point was seen: (x, y) in the ideal picture and, with depth, x in the virtual right one.
struct Observation {
  double x_px = 0, y_px = 0;
  /// NaN: no depth, two residuals instead of three. (Near the left border a true value is negative.)
  double right_px = std::numeric_limits<double>::quiet_NaN();
  double inverse_variance = 1;  ///< 1/px^2, the same for all residuals of the observation

  bool HasDepth() const { return !std::isnan(right_px); }
};

/// Chi-square bounds at 95 % for two and three residuals; also the squares of Huber's widths.
constexpr double kChi2Mono = 5.991, kChi2Stereo = 7.815;

}  // namespace yorb

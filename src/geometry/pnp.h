// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/random.h"
#include "geometry/ransac.h"
#include "geometry/rigid3.h"

namespace yorb {

/// All poses `cam_from_world`, four at most, from which three points are seen in three directions (in the camera frame,
/// of any length). After Persson and Nordberg, "Lambda Twist: An Accurate Fast Robust Perspective Three Point Solver",
/// ECCV 2018. Points on a line, equal directions and values that are not finite give none.
std::vector<Rigid3> SolveP3p(const std::array<Eigen::Vector3d, 3>& directions_in_cam,
                             const std::array<Eigen::Vector3d, 3>& points_in_world);

/// A known point and where it is seen.
struct PnpObservation {
  Eigen::Vector3d x_in_world;
  Eigen::Vector2d point_on_plane;  ///< on z = 1 of the camera frame: ((x_px - cx) / fx, (y_px - cy) / fy)
  double deviation = 1;            ///< standard deviation on that plane: pixels / focal length
};

struct PnpOptions {
  RansacOptions ransac;
  double max_deviations = 2.45;  ///< an inlier's error at most, in standard deviations (2.45: 95 % of two residuals)
  int min_inliers = 10;          ///< fewer: no pose

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("ransac", self.ransac);
    visit("max_deviations", self.max_deviations, Range(0.1, 100));
    visit("min_inliers", self.min_inliers, Range(3, 100000));
  }
};

struct PnpResult {
  Rigid3 cam_from_world;        ///< of the best sample; refining it with all inliers is the caller's
  std::vector<bool> is_inlier;  ///< a row an observation
  size_t num_inliers = 0;
  int iterations = 0;
};

/// The pose that most observations agree on (the truncated squares of MSAC), or nothing.
std::optional<PnpResult> PnpRansac(const std::vector<PnpObservation>& observations, const PnpOptions& options,
                                   Random random);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/rigid3.h"
#include "optimize/observation.h"

namespace yorb {

/// One known point and where this picture sees it.
struct PoseObservation {
  Eigen::Vector3d x_in_world;
  Observation seen;
  double weight = 1;  ///< multiplies the cost; below 1 for points that may move
};

struct PoseEstimate {
  Rigid3 cam_from_world;
  std::vector<bool> is_inlier;  ///< a row an observation
  size_t num_inliers = 0;
  double cost = 0;  ///< half the weighted chi-square of the inliers at the end
  /// J^T W J of the inliers at the end, for (rotation, translation) of the step in Rigid3::FromStep.
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
};

/// The pose that least squares asks for: Levenberg-Marquardt with Huber weights, in four rounds after each of which
/// every observation is judged anew by its chi-square (95 %); the last round goes without Huber, as in ORB-SLAM2.
/// Points at or behind the camera and observations that are not finite are outliers. Where fewer than three
/// observations remain, the given pose comes back without inliers.
PoseEstimate OptimizePose(const Rigid3& cam_from_world, const std::vector<PoseObservation>& observations,
                          const Projection& projection);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
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

/// A point of a surface that this picture sees, and the plane that it is known to lie on.
struct PlaneObservation {
  Eigen::Vector3d x_in_cam;         ///< metres, as measured
  Eigen::Vector3d normal_in_world;  ///< of length 1
  double offset = 0;                ///< normal . x of the points of the plane, metres
  double sigma_m = 0.01;            ///< of the distance to the plane
  double weight = 1;                ///< multiplies the cost
};

struct PoseEstimate {
  Rigid3 cam_from_world;
  std::vector<bool> is_inlier;  ///< a row an observation
  size_t num_inliers = 0;
  double cost = 0;  ///< half the weighted chi-square of the inliers at the end
  /// J^T W J of the inliers at the end, for (rotation, translation) of the step in Rigid3::FromStep.
  Matrix6d information = Matrix6d::Zero();
  Matrix6d held_by = Matrix6d::Zero();  ///< the same of the planes and of what was expected

  /// One standard deviation of the place, in metres, as far as the inliers err each by itself; infinite where they
  /// leave it open.
  double SigmaOfPlace() const;
};

/// A pose that is known beforehand: half of error^T * information * error, for the step from it to another, is the cost
/// of that.
struct ExpectedPose {
  Rigid3 cam_from_world;
  Matrix6d information;
};

/// The pose that least squares asks for: Levenberg-Marquardt with Huber weights, in four rounds after each of which
/// every observation is judged anew by its chi-square (95 %); the last round goes without Huber, as in ORB-SLAM2.
/// Points at or behind the camera and observations that are not finite are outliers. Where fewer than three
/// observations remain, the given pose comes back without inliers. Planes are held to from beginning to end, with
/// Huber's loss, and are not judged; so is what is expected. Cost and information are of the points alone.
PoseEstimate OptimizePose(const Rigid3& cam_from_world, const std::vector<PoseObservation>& observations,
                          const Projection& projection, const std::vector<PlaneObservation>& planes = {},
                          const std::optional<ExpectedPose>& expected = {});

/// The pose near a given one at which a depth picture lies best on planes and near to what is expected: a wall says
/// nothing of where along it the camera is.
Rigid3 AlignToPlanes(const Rigid3& cam_from_world, const std::vector<PlaneObservation>& planes,
                     const ExpectedPose& expected);

/// J^T W J of observations at a pose, for the step of Rigid3::FromStep.
Matrix6d InformationAt(const Rigid3& cam_from_world, const std::vector<PoseObservation>& observations,
                       const Projection& projection);

}  // namespace yorb

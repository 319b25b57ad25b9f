// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "map/map.h"
#include "matching/by_projection.h"
#include "optimize/pose.h"

namespace yorb {

/// A point of the frame before that is no landmark, known by its depth, and the keypoint that sees it now.
struct DepthPoint {
  uint32_t row = 0;
  Eigen::Vector3d x_in_world;
};

/// A frame's pose and what speaks for it.
struct Fix {
  Rigid3 cam_from_world;
  std::vector<LandmarkId> matches;  ///< a row a keypoint of the frame; inliers of the last optimisation only
  /// How unsure the points leave the place, in metres, if they err each by itself: one standard deviation.
  double sigma_m = 0;
  Matrix6d information = Matrix6d::Zero();  ///< of its points, as in PoseEstimate
  Matrix6d held_by = Matrix6d::Zero();      ///< beside its points, as in PoseEstimate
  std::vector<DepthPoint> by_depth;         ///< inliers too, by rising rows, where `matches` has no landmark
  std::vector<PoseObservation> followed;    ///< inliers beside the keypoints: found by optical flow
  size_t num_matched = 0;                   ///< before outliers were taken out
  size_t num_inliers = 0;                   ///< of landmarks

  size_t num_at_keypoints() const { return num_inliers + by_depth.size(); }
  size_t num_in_all() const { return num_at_keypoints() + followed.size(); }
};

using Planes = std::vector<PlaneObservation>;

/// What speaks for a pose beside the keypoints.
struct Support {
  Planes planes;                          ///< what surfaces say
  std::optional<ExpectedPose> expected;   ///< what the camera's motion says
  std::vector<PoseObservation> followed;  ///< known points where optical flow found them

  bool empty() const { return planes.empty() && !expected && followed.empty(); }
};

/// Optimises a pose on landmarks (`matches`, a row a keypoint), on points of the frame before where there is none
/// (`by_depth`) and on what else there is, and gives it with the inliers.
Fix FixFromLandmarks(const Frame& frame, const Map& map, const Rigid3& guess, const std::vector<LandmarkId>& matches,
                     const std::vector<DepthPoint>& by_depth, const Support& support = {});

/// The same on known points (`rows`: for each keypoint a row of `points`, or -1).
Fix FixFromPoints(const Frame& frame, const Rigid3& guess, const std::vector<KnownPoint>& points,
                  const std::vector<int>& rows, const Support& support = {});

/// The pose anew on the inliers of a fix, whose keypoints have moved a little. The fix itself where that loses most.
Fix Refit(const Frame& frame, const Map& map, const Fix& fix, Support support = {});

/// What a fix rests on that a bundle of landmarks does not know, surfaces and points of the frame before: J^T W J for
/// the step of Rigid3::FromStep.
Matrix6d BesideLandmarks(const Frame& frame, const Fix& fix);

}  // namespace yorb

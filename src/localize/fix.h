// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/map.h"
#include "matching/by_projection.h"
#include "optimize/pose.h"

namespace yorb {

/// A frame's pose and what speaks for it.
struct Fix {
  Rigid3 cam_from_world;
  std::vector<LandmarkId> matches;  ///< a row a keypoint of the frame; inliers of the last optimisation only
  /// How unsure the points leave the place, in metres, if they err each by itself: one standard deviation.
  double sigma_m = 0;
  size_t num_matched = 0;           ///< before outliers were taken out
  size_t num_inliers = 0;           ///< of landmarks
  size_t num_inliers_by_depth = 0;  ///< of points of the frame before that are no landmarks
};

using Planes = std::vector<PlaneObservation>;

/// Optimises a pose on landmarks (`matches`, a row a keypoint) and on what surfaces say (`planes`), and gives it with
/// the inliers.
Fix FixFromLandmarks(const Frame& frame, const Map& map, const Rigid3& guess, const std::vector<LandmarkId>& matches,
                     const Planes& planes = {});

/// The pose anew on the inliers of a fix, whose keypoints have moved a little. The fix itself where that loses most.
Fix Refit(const Frame& frame, const Map& map, const Fix& fix, const Planes& planes = {});

/// The same on known points (`rows`: for each keypoint a row of `points`, or -1).
Fix FixFromPoints(const Frame& frame, const Rigid3& guess, const std::vector<KnownPoint>& points,
                  const std::vector<int>& rows, const Planes& planes = {});

}  // namespace yorb

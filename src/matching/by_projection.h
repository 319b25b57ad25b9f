// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "geometry/rigid3.h"
#include "map/map.h"
#include "matching/search.h"

namespace yorb {

/// A point of which we know the place and the looks: a landmark, or a point of the frame before with its own depth.
struct KnownPoint {
  Eigen::Vector3d x_in_world = Eigen::Vector3d::Zero();
  Descriptor descriptor{};
  int octave = 0;            ///< at which it was seen
  float angle_rad = 0;       ///< of the keypoint that saw it
  LandmarkId landmark;       ///< not valid: a point of the frame before, known by its depth alone
  bool is_grown_up = false;  ///< may be found among suspects
};

/// Finds points of the frame before in this one, near where the guessed pose puts them. Gives for each keypoint the row
/// of `points`, or -1. Octaves are bounded by the way the camera moved along its axis.
std::vector<int> MatchKnownPoints(const Frame& frame, const Rigid3& cam_from_world, const Rigid3& last_cam_from_world,
                                  const std::vector<KnownPoint>& points, float radius_px);

/// A landmark that the frame should see.
struct ExpectedLandmark {
  LandmarkId id;
  const Landmark* landmark = nullptr;  ///< of the snapshot that the caller holds
  SearchArea area;
};

/// The area in which `landmark` should appear from that pose: nothing when it is behind, outside of the picture, out of
/// its range of distances, or seen from too far aside (60 degrees). `widening` scales the radius.
std::optional<SearchArea> ExpectLandmark(const Landmark& landmark, const Frame& frame, const Rigid3& cam_from_world,
                                         float widening);

/// Finds expected landmarks among the keypoints that have none yet (`taken[index]`). Gives for each keypoint the row of
/// `expected`, or -1.
std::vector<int> MatchExpected(const Frame& frame, const std::vector<ExpectedLandmark>& expected,
                               const std::vector<bool>& taken);

}  // namespace yorb

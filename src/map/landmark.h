// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "features/frame.h"
#include "map/event.h"

namespace yorb {

/// Which keypoint of which keyframe sees a landmark.
struct LandmarkView {
  KeyframeId keyframe;
  uint32_t index = 0;
};

/// A point of the world. Written by Map's methods only.
struct Landmark {
  LandmarkId id;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();        ///< in the world
  Eigen::Vector3d view_direction = Eigen::Vector3d::Zero();  ///< mean of the unit vectors from the cameras to the point
  double min_distance = 0, max_distance = 0;                 ///< at which the pyramid can see it
  Descriptor descriptor{};                                   ///< of its views the one nearest to all others
  KeyframeId reference;                                      ///< the view that it follows when the map is corrected
  KeyframeId first_keyframe;                                 ///< in which it was born
  int num_visible = 0;                                       ///< frames in which it should have been seen
  int num_found = 0;                                         ///< frames in which it was
  std::vector<LandmarkView> views;                           ///< by ascending keyframe id; never empty

  /// Whether it was seen in its place often enough that it can be found even where people are presumed.
  bool IsGrownUp() const { return views.size() >= kGrownUp; }
  static constexpr size_t kGrownUp = 4;  ///< keyframes

  /// The view of that keyframe, or null.
  const LandmarkView* ViewOf(KeyframeId keyframe) const;

  /// The pyramid level at which a camera at `distance` should find it.
  int PredictedOctave(double distance, const ScaleTable& scales) const;
};

}  // namespace yorb

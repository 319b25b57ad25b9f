// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/options.h"

namespace yorb {

/// Options of the tracker; YAML group `tracking`.
struct TrackingOptions {
  double lost_after_s = 0.5;         ///< without a confirmed pose for so long, "recently lost" becomes "lost"
  double new_map_after_s = 2;        ///< in sight of something unknown, a lost camera begins a new sub-map
  int min_first_points = 100;        ///< points with depth that the first keyframe of a sub-map needs
  int min_inliers = 30;              ///< matched landmarks that confirm a pose
  int min_inliers_after_loss = 50;   ///< the same, shortly after tracking was lost
  int min_inliers_going_on = 15;     ///< the same, where the camera only moves on as it did
  double search_radius_px = 15;      ///< about the predicted place of a point of the frame before, at octave 0
  double local_widening = 3;         ///< of the search for landmarks of the local map
  int max_local_keyframes = 80;      ///< whose landmarks are sought in each frame
  double keyframe_ratio = 0.75;      ///< a keyframe is due when fewer of the reference's landmarks are still matched
  double keyframe_shift = 0.1;       ///< or when the camera is so far from the reference, in units of the median depth
  double keyframe_turn_deg = 15;     ///< or has turned so far from it
  double keyframe_interval_s = 1.0;  ///< after so long one that is due does not wait for the mapper
  double relocalize_radius_px = 30;  ///< search about a coarse pose
  bool straight_edges = true;        ///< in the pictures of keyframes keep the map from turning

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("lost_after_s", self.lost_after_s, Range(0, 60));
    visit("new_map_after_s", self.new_map_after_s, Range(0, 3600));
    visit("min_first_points", self.min_first_points, Range(10, 20000));
    visit("min_inliers", self.min_inliers, Range(6, 1000));
    visit("min_inliers_after_loss", self.min_inliers_after_loss, Range(6, 1000));
    visit("min_inliers_going_on", self.min_inliers_going_on, Range(6, 1000));
    visit("search_radius_px", self.search_radius_px, Range(1, 200));
    visit("local_widening", self.local_widening, Range(0.5, 20));
    visit("max_local_keyframes", self.max_local_keyframes, Range(1, 1000));
    visit("keyframe_ratio", self.keyframe_ratio, Range(0, 1));
    visit("keyframe_shift", self.keyframe_shift, Range(0, 100));
    visit("keyframe_turn_deg", self.keyframe_turn_deg, Range(0, 180));
    visit("keyframe_interval_s", self.keyframe_interval_s, Range(0, 3600));
    visit("relocalize_radius_px", self.relocalize_radius_px, Range(1, 200));
    visit("straight_edges", self.straight_edges, AnyValue());
  }
};

}  // namespace yorb

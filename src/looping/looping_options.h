// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/options.h"

namespace yorb {

/// Options of loop closing; YAML group `looping`.
struct LoopingOptions {
  bool close_loops = true;  ///< and join sub-maps; needs a vocabulary
  int min_inliers = 40;     ///< landmarks of the old place that the new keyframe sees; see `min_share`
  /// Of those that it should see from there. Within a sub-map, where more of them are seen, down to two thirds of
  /// `min_inliers` and `min_spread` are enough.
  double min_share = 0.12;
  double min_spread = 0.5;         ///< of the picture, over how much they must scatter
  int certain_inliers = 100;       ///< so many, at `certain_share`, need no second keyframe that agrees
  double certain_share = 0.3;      ///< see there
  double drift_per_metre = 0.1;    ///< a loop that asks for more than this of the path between is none
  double max_drift_turn_deg = 25;  ///< nor one that turns the camera by more
  bool adjust_globally = true;     ///< bundle adjustment of everything once a loop is closed

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("close_loops", self.close_loops, AnyValue());
    visit("min_inliers", self.min_inliers, Range(10, 1000));
    visit("min_share", self.min_share, Range(0, 1));
    visit("min_spread", self.min_spread, Range(0, 1));
    visit("certain_inliers", self.certain_inliers, Range(10, 100000));
    visit("certain_share", self.certain_share, Range(0, 1));
    visit("drift_per_metre", self.drift_per_metre, Range(0, 10));
    visit("max_drift_turn_deg", self.max_drift_turn_deg, Range(0, 180));
    visit("adjust_globally", self.adjust_globally, AnyValue());
  }
};

}  // namespace yorb

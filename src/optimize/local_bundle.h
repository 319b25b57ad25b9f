// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "map/map.h"
#include "optimize/bundle.h"

namespace yorb {

struct LocalBundleOptions {
  size_t max_moving = 20;  ///< keyframes whose poses are adjusted
  size_t max_fixed = 40;   ///< keyframes that see the same landmarks and hold the rest in place
  int min_shared = 15;     ///< landmarks that make a keyframe part of the neighbourhood
};

/// What a local bundle adjustment found; the mapper applies it.
struct LocalBundle {
  std::vector<std::pair<KeyframeId, Rigid3>> poses;
  std::vector<std::pair<LandmarkId, Eigen::Vector3d>> points;
  std::vector<std::pair<LandmarkId, KeyframeId>> outliers;  ///< views that do not fit
  size_t num_observations = 0;
  double initial_cost = 0, final_cost = 0;
  bool was_stopped = false;
};

/// Adjusts a keyframe, its neighbours and what they see, with the keyframes around held fixed.
LocalBundle AdjustLocally(const Map& map, KeyframeId center, const LocalBundleOptions& options,
                          const std::function<bool()>& should_stop);

}  // namespace yorb

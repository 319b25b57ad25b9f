// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "map/map.h"
#include "optimize/bundle.h"

namespace yorb {

/// What the adjustment of a part of a map found; the mapper applies it.
struct MapBundle {
  std::vector<std::pair<KeyframeId, Rigid3>> poses;  ///< of the keyframes that may move
  std::vector<std::pair<LandmarkId, Eigen::Vector3d>> points;
  std::vector<std::pair<LandmarkId, KeyframeId>> outliers;  ///< views that do not fit
  size_t num_observations = 0;
  double initial_cost = 0, final_cost = 0;
  bool was_stopped = false;
};

/// Which part of a map is adjusted. Landmarks' views from keyframes that are not named do not count.
struct MapBundlePart {
  std::vector<KeyframeId> inside;  ///< they and all landmarks that they see are adjusted
  std::vector<KeyframeId> held;    ///< of those, the ones whose poses stay
  std::vector<KeyframeId> around;  ///< poses that stay, and hold what the others see in place
};

/// Adjusts a part of a map; all its keyframes are there.
MapBundle AdjustMapBundle(const Map& map, const MapBundlePart& part, const BundleOptions& options,
                          const std::function<bool()>& should_stop);

}  // namespace yorb

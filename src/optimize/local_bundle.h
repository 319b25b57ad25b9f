// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "optimize/map_bundle.h"

namespace yorb {

struct LocalBundleOptions {
  size_t max_moving = 20;  ///< keyframes whose poses are adjusted
  size_t max_fixed = 40;   ///< keyframes that see the same landmarks and hold the rest in place
  int min_shared = 15;     ///< landmarks that make a keyframe part of the neighbourhood
};

/// What a local bundle adjustment found; the mapper applies it.
using LocalBundle = MapBundle;

/// Adjusts a keyframe, its neighbours and what they see, with the keyframes around held fixed.
LocalBundle AdjustLocally(const Map& map, KeyframeId center, const LocalBundleOptions& options,
                          const std::function<bool()>& should_stop);

}  // namespace yorb

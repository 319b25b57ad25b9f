// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "optimize/map_bundle.h"

namespace yorb {

struct GlobalBundleOptions {
  KeyframeId held;  ///< its pose stays; not valid: the first keyframe of the world, or else the oldest one
  BundleOptions bundle;
};

/// What a global bundle adjustment found; to be applied to the map as it is by then, with what was added meanwhile.
using GlobalBundle = MapBundle;

/// Adjusts keyframes and all landmarks that they see. Keyframes that are not there (any more) are left out.
GlobalBundle AdjustGlobally(const Map& map, const std::vector<KeyframeId>& keyframes,
                            const GlobalBundleOptions& options = {}, const std::function<bool()>& should_stop = {});

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/random.h"
#include "localize/place_memory.h"
#include "looping/looping_options.h"
#include "map/map.h"

namespace yorb {

/// A keyframe shows a place that the map knows already, from elsewhere in its graph.
struct Recognition {
  KeyframeId newer, older;
  Rigid3 cam_from_world;  ///< of the newer keyframe, in the world in which the older one is now
  size_t num_inliers = 0;
  double share = 0;  ///< of what should be seen
};

/// Whether two keyframes are neighbours, or have a neighbour in common: then local mapping ties them together already.
bool AreNear(const Map& map, KeyframeId a, KeyframeId b);

/// Looks at one keyframe against one place. Nothing where too little agrees.
std::optional<Recognition> Recognize(const Map& map, const Keyframe& newer, const Keyframe& older,
                                     const LoopingOptions& options, Random random);

/// Whether a keyframe near the newer one, at the pose that it must have if the recognition is right, sees the older
/// place, too.
bool IsConfirmed(const Map& map, const Recognition& recognition, const LoopingOptions& options);

/// A recognition that nothing confirmed, in a form that corrections of the map leave right.
struct Glimpse {
  KeyframeId newer, older;
  Rigid3 newer_from_older;
};

/// Whether another keyframe was recognized before, by itself, where this recognition says that it must be. Only within
/// a sub-map, where there is a drift to be judged as well.
bool Agrees(const Map& map, const Recognition& recognition, const Glimpse& earlier);

/// Whether the map can have drifted so far on the way between the two; always so between sub-maps.
bool IsPlausible(const Map& map, const Recognition& recognition, const LoopingOptions& options);

}  // namespace yorb

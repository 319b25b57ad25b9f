// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: localize. Where in a map a frame was taken.
// Takes: frames, map snapshots. Gives: fixes (a pose with what speaks for it). Owns: an index of places that follows
// the map (PlaceMemory). Runs on: whichever thread calls. May not: change the map, know what came before.
#pragma once

#include <optional>

#include "core/random.h"
#include "localize/fix.h"
#include "map/map.h"

namespace yorb {

/// What a recognised place must show.
struct RecognitionTerms {
  size_t min_inliers = 50;  ///< landmarks
  double radius_px = 30;    ///< of the search about a coarse pose
  double min_share = 0;     ///< of the landmarks that should be seen from there, see Evidence; 0: not asked for
  double min_spread = 0;    ///< see there
};

/// A pose by descriptors alone and PnP with RANSAC, refined on its inliers. Nothing where too few agree.
std::optional<Fix> FixByAppearance(const Frame& frame, const std::vector<KnownPoint>& points, Random random);

/// A pose against what one keyframe sees: descriptors, PnP by RANSAC, and, where `terms` ask for more, a guided search
/// for the landmarks that the pose says must be there.
std::optional<Fix> RelocalizeAgainst(const Frame& frame, const Map& map, const Keyframe& keyframe,
                                     const RecognitionTerms& terms, Random random);

/// The same against one keyframe after the other; the first that holds.
std::optional<Fix> Relocalize(const Frame& frame, const Map& map, const std::vector<KeyframeId>& candidates,
                              const RecognitionTerms& terms, Random random);

/// Where to look without a memory for places: the newest keyframes, and a few of the older ones in turn, so that every
/// place is asked about within some frames.
std::vector<KeyframeId> NewestAndSomeOlder(const Map& map, FrameId frame);

}  // namespace yorb

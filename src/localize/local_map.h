// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "localize/fix.h"
#include "map/map.h"
#include "matching/by_projection.h"

namespace yorb {

/// The part of the map that a frame looks at.
struct LocalMap {
  std::vector<KeyframeId> keyframes;  ///< those that share landmarks with the frame, and their neighbours
  KeyframeId reference;               ///< the one that shares most; not valid when none does
};

/// Collects the local map by the landmarks that the frame has matched so far, `max_keyframes` at most.
LocalMap CollectLocalMap(const Map& map, const std::vector<LandmarkId>& matches, size_t max_keyframes);

/// The landmarks of the local map that the frame should see from that pose and has not matched yet.
std::vector<ExpectedLandmark> ExpectLocalLandmarks(const Map& map, const LocalMap& local, const Frame& frame,
                                                   const Rigid3& cam_from_world, const std::vector<LandmarkId>& matches,
                                                   float widening);

/// The pose anew, on what it rested on so far and the expected landmarks that are found among the other keypoints.
Fix FixWithExpected(const Frame& frame, const Map& map, const Fix& coarse,
                    const std::vector<ExpectedLandmark>& expected, Support support = {});

}  // namespace yorb

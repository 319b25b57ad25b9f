// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/map.h"

namespace yorb {

/// How much the views of a landmark pin it down: one with depth counts as two.
int NumRays(const Map& map, const Landmark& landmark);

/// Takes out of the map the young landmarks that did not prove themselves: found in less than a quarter of the frames
/// that should have seen them, or seen by too few keyframes after two more came. Gives those that are still on trial.
std::vector<LandmarkId> CullRecentLandmarks(Map& map, const std::vector<LandmarkId>& recent);

/// Takes out the landmarks that turned out to move: seen to have gone several times, and more often than they were
/// found since the last keyframe. Gives how many.
size_t RemoveGone(Map& map, const std::vector<LandmarkCount>& counts);

/// Removes the neighbours of a keyframe of which nearly all (`redundant_share`) is seen by three others at the same or
/// a finer scale.
void CullKeyframes(Map& map, KeyframeId center, double redundant_share);

}  // namespace yorb

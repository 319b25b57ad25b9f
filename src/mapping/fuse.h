// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/map.h"

namespace yorb {

/// Landmarks of a keyframe are sought in its neighbours, and theirs in it: new views are added, and two landmarks that
/// turn out to be one are merged into the one that more keyframes see.
void FuseWithNeighbours(Map& map, KeyframeId keyframe, size_t num_neighbours);

/// The same between two groups of keyframes that have turned out to show one place: each looks for the landmarks of the
/// other group.
void FuseAcross(Map& map, const std::vector<KeyframeId>& ones, const std::vector<KeyframeId>& others);

}  // namespace yorb

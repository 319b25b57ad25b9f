// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "map/map.h"

namespace yorb {

/// Landmarks of a keyframe are sought in its neighbours, and theirs in it: new views are added, and two landmarks that
/// turn out to be one are merged into the one that more keyframes see.
void FuseWithNeighbours(Map& map, KeyframeId keyframe, size_t num_neighbours);

}  // namespace yorb

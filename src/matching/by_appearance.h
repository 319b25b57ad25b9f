// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/map.h"
#include "matching/search.h"

namespace yorb {

/// Matches a frame to the landmarks of a keyframe by descriptors alone, wherever they are in the picture: the nearest
/// both ways, clearly nearer than the second, and turned as most are. Gives for each keypoint of `frame` a landmark of
/// the keyframe, not valid where there is none.
std::vector<LandmarkId> MatchByAppearance(const Frame& frame, const Keyframe& keyframe, const Map& map);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/map.h"
#include "matching/by_projection.h"

namespace yorb {

/// The landmarks of a keyframe as that keyframe saw them.
std::vector<KnownPoint> KnownPointsOf(const Keyframe& keyframe, const Map& map);

/// Finds known points in a frame by descriptors alone, wherever they are in the picture: the nearest both ways, clearly
/// nearer than the second, and turned as most are; not among suspects. Gives for each keypoint the row of `points`,
/// or -1.
std::vector<int> MatchByAppearance(const Frame& frame, const std::vector<KnownPoint>& points);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "map/map.h"
#include "matching/search.h"

namespace yorb {

/// Two keypoints that may show the same point, which is no landmark yet.
struct KeypointPair {
  uint32_t first = 0, second = 0;
};

/// Pairs keypoints without landmarks of two keyframes with known poses: strictly alike, near the epipolar line (or,
/// with depth, near the place where the point must appear), and turned as most are.
std::vector<KeypointPair> MatchUnknown(const Keyframe& first, const Keyframe& second);

}  // namespace yorb

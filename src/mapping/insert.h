// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/map.h"

namespace yorb {

/// Adds a proposed keyframe with the landmarks that its matches name, as far as they are still there.
KeyframeId InsertKeyframe(Map& map, const Proposal& proposal);

/// Makes landmarks of keypoints with depth that have none: all close ones, and the nearest hundred in any case.
/// Gives the new ones.
std::vector<LandmarkId> AddLandmarksByDepth(Map& map, KeyframeId keyframe);

}  // namespace yorb

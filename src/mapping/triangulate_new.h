// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/map.h"

namespace yorb {

/// Makes landmarks of keypoints that a keyframe and its neighbours see and the map does not know yet: by depth where
/// that is surer, else by parallax. Gives the new ones.
std::vector<LandmarkId> TriangulateNew(Map& map, KeyframeId keyframe, size_t num_neighbours);

}  // namespace yorb

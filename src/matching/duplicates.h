// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/map.h"
#include "matching/search.h"

namespace yorb {

/// A landmark and a keypoint of a keyframe that show the same point.
struct Sighting {
  LandmarkId landmark;
  uint32_t index = 0;
};

/// Finds landmarks of a list in a keyframe that does not see them yet, each near where it must appear and strictly
/// alike. The keypoint may see another landmark already: then the two are one point.
std::vector<Sighting> FindSightings(const Map& map, const std::vector<LandmarkId>& landmarks, const Keyframe& keyframe);

}  // namespace yorb

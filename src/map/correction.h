// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "map/map.h"

namespace yorb {

/// Two keyframes that show the same place.
struct SamePlace {
  KeyframeId newer, older;
};

/// What looking at the map as a whole has found out, on a snapshot that may be old by now: how its keyframes and
/// landmarks lie. The mapper merges it into the map.
struct Correction {
  std::vector<std::pair<KeyframeId, Rigid3>> poses;  ///< cam_from_world
  std::vector<std::pair<LandmarkId, Eigen::Vector3d>> points;
  std::vector<std::pair<LandmarkId, KeyframeId>> outliers;  ///< views that do not fit
  std::optional<SamePlace> place;                           ///< the reason, where it is a loop or joins two sub-maps
};

/// Moves the map: the one rule by which old knowledge meets a map that has grown meanwhile. A keyframe that the
/// correction does not know follows its nearest ancestor that it does know; a landmark that it does not know follows
/// its reference. What is not there any more is passed over. Outliers and the place are the caller's.
void MoveMap(Map& map, const Correction& correction);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/map.h"

namespace yorb {

/// The directions, in the world of a sub-map, in which its straight edges run: what its keyframes see, as they lie now.
/// The first keyframes count most, since turns drift from there on.
std::vector<Eigen::Vector3d> DirectionsOf(const Map& map, KeyframeId root);

}  // namespace yorb

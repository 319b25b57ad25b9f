// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "looping/recognize.h"
#include "map/correction.h"

namespace yorb {

/// How the map must lie if the recognition is right. Within a sub-map: the keyframes' poses by a pose graph over the
/// spanning tree, strong neighbours and all loops, the root held fixed. Between two: the younger sub-map moves as one
/// into the world of the elder.
Correction Close(const Map& map, const Recognition& recognition);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "localize/fix.h"
#include "motion/mover_finder.h"

namespace yorb {

/// The points of a frame that are on what moves, a row a keypoint; empty where there are none.
std::vector<bool> PointsOnMovers(const Frame& frame, const MovingCells& moving);

/// Which suspects are to go: those that no landmark speaks for (`matches`: a row a point). The others have shown that
/// they stand still.
std::vector<bool> DoubtfulSuspects(const Frame& frame, const std::vector<LandmarkId>& matches);

/// The points whose rows are not marked, with the numbers that their rows have once the marked ones are gone.
std::vector<DepthPoint> WithoutRows(const std::vector<DepthPoint>& points, const std::vector<bool>& is_marked);

}  // namespace yorb

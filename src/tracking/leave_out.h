// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "features/frame.h"
#include "motion/mover_finder.h"

namespace yorb {

/// The points of a frame that are on what moves, a row a keypoint; empty where there are none.
std::vector<bool> PointsOnMovers(const Frame& frame, const MovingCells& moving);

/// The frame without the rows that are marked.
FramePtr WithoutRows(const FramePtr& frame, const std::vector<bool>& is_marked);

/// The same of any rows that belong to the keypoints.
template <typename Row>
std::vector<Row> WithoutRows(std::vector<Row> rows, const std::vector<bool>& is_marked) {
  size_t kept = 0;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (!is_marked[i]) rows[kept++] = rows[i];
  }
  rows.resize(kept);
  return rows;
}

}  // namespace yorb

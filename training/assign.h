// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "training/batch.h"
#include "training/layout.h"

namespace yorb {

/// Which cells of one head answer for which boxes; all vectors run alongside.
struct Assignment {
  std::vector<int64_t> picture, row, column, anchor;
  std::vector<int64_t> class_index;
  std::vector<float> boxes;    ///< four numbers each: centre x, y from the cell's corner, width, height; in cells
  std::vector<float> anchors;  ///< two numbers each: width and height of the anchor in cells

  size_t size() const { return picture.size(); }
};

/// Both kinds of one head.
struct LevelAssignment {
  Assignment sure;      ///< these learn box, objectness and class
  Assignment doubtful;  ///< these learn nothing, nor are they background
};

/// YOLOv5's rule: a box belongs to each anchor whose sides differ from its own by less than a factor of four, in the
/// cell of its centre and in the nearer neighbour of each direction.
LevelAssignment AssignAnchors(const std::vector<Target>& targets, const std::array<Anchor, 3>& anchors, int stride,
                              int rows, int columns);

/// The share of boxes that at least one anchor of the layout fits by that rule: the anchor check.
double AnchorRecall(const std::vector<Target>& targets, const Layout& layout);

constexpr double kMostAnchorRatio = 4.0;

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/assign.h"

#include <algorithm>
#include <cmath>

namespace yorb {
namespace {

bool Fits(const SceneBox& box, const Anchor& anchor) {
  const double x = box.width() / anchor.width_px, y = box.height() / anchor.height_px;
  return std::max({x, 1 / x, y, 1 / y}) < kMostAnchorRatio;
}

struct Cell {
  int row = 0, column = 0;
};

/// The cell of a point (in cells) and its neighbours across the nearer borders.
std::vector<Cell> CellsNear(double x, double y, int rows, int columns) {
  const int column = std::clamp(static_cast<int>(x), 0, columns - 1);
  const int row = std::clamp(static_cast<int>(y), 0, rows - 1);
  std::vector<Cell> cells{{row, column}};
  const int next_column = x - column < 0.5 ? column - 1 : column + 1;
  const int next_row = y - row < 0.5 ? row - 1 : row + 1;
  if (next_column >= 0 && next_column < columns) cells.push_back({row, next_column});
  if (next_row >= 0 && next_row < rows) cells.push_back({next_row, column});
  return cells;
}

}  // namespace

LevelAssignment AssignAnchors(const std::vector<Target>& targets, const std::array<Anchor, 3>& anchors, int stride,
                              int rows, int columns) {
  LevelAssignment level;
  const float cell_px = static_cast<float>(stride);
  for (const Target& target : targets) {
    const SceneBox& box = target.box;
    Assignment& to = box.is_doubtful ? level.doubtful : level.sure;
    const float x = (box.left + box.right) / 2 / cell_px, y = (box.top + box.bottom) / 2 / cell_px;
    for (size_t a = 0; a < anchors.size(); ++a) {
      if (!Fits(box, anchors[a])) continue;
      for (const Cell& cell : CellsNear(x, y, rows, columns)) {
        to.picture.push_back(target.picture);
        to.row.push_back(cell.row);
        to.column.push_back(cell.column);
        to.anchor.push_back(static_cast<int64_t>(a));
        to.class_index.push_back(box.class_index);
        to.boxes.insert(to.boxes.end(), {x - static_cast<float>(cell.column), y - static_cast<float>(cell.row),
                                         box.width() / cell_px, box.height() / cell_px});
        to.anchors.insert(to.anchors.end(), {anchors[a].width_px / cell_px, anchors[a].height_px / cell_px});
      }
    }
  }
  return level;
}

double AnchorRecall(const std::vector<Target>& targets, const Layout& layout) {
  if (targets.empty()) return 1;
  const auto is_fit = [&](const Target& target) {
    return std::any_of(layout.anchors.begin(), layout.anchors.end(), [&](const auto& level) {
      return std::any_of(level.begin(), level.end(), [&](const Anchor& anchor) { return Fits(target.box, anchor); });
    });
  };
  const auto num_fit = std::count_if(targets.begin(), targets.end(), is_fit);
  return static_cast<double>(num_fit) / static_cast<double>(targets.size());
}

}  // namespace yorb

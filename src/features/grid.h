// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "camera/rig.h"

namespace yorb {

/// Points sorted into square cells, to find those near a pixel without looking at all.
class Grid {
 public:
  Grid() = default;
  Grid(const PixelBounds& bounds, const std::vector<Eigen::Vector2f>& points_px);

  /// Calls `visit(index)` for each point of the cells that a square of half side `radius_px` about (x, y) touches, in
  /// ascending order of cells and points. The caller checks the distance.
  template <typename Visitor>
  void VisitNear(float x, float y, float radius_px, Visitor&& visit) const {
    if (starts_.empty()) return;
    const int first_column = Clamp((x - radius_px - bounds_.min_x) / kCellPx, columns_);
    const int last_column = Clamp((x + radius_px - bounds_.min_x) / kCellPx, columns_);
    const int first_row = Clamp((y - radius_px - bounds_.min_y) / kCellPx, rows_);
    const int last_row = Clamp((y + radius_px - bounds_.min_y) / kCellPx, rows_);
    for (int row = first_row; row <= last_row; ++row) {
      const uint32_t end = starts_[static_cast<size_t>(row * columns_ + last_column + 1)];
      for (uint32_t i = starts_[static_cast<size_t>(row * columns_ + first_column)]; i < end; ++i) visit(indices_[i]);
    }
  }

 private:
  static constexpr float kCellPx = 10;
  static int Clamp(float cell, int count) {
    if (!(cell > 0)) return 0;
    return cell < static_cast<float>(count) ? static_cast<int>(cell) : count - 1;
  }

  PixelBounds bounds_;
  int columns_ = 0, rows_ = 0;
  std::vector<uint32_t> starts_;  ///< of each cell in indices_, row by row, and one past the last
  std::vector<uint32_t> indices_;
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/grid.h"

#include <cmath>

namespace yorb {

Grid::Grid(const PixelBounds& bounds, const std::vector<Eigen::Vector2f>& points_px) : bounds_(bounds) {
  columns_ = std::max(1, static_cast<int>(std::ceil((bounds.max_x - bounds.min_x) / kCellPx)));
  rows_ = std::max(1, static_cast<int>(std::ceil((bounds.max_y - bounds.min_y) / kCellPx)));
  starts_.assign(static_cast<size_t>(columns_ * rows_ + 1), 0);
  indices_.resize(points_px.size());

  std::vector<uint32_t> cells(points_px.size());
  for (size_t i = 0; i < points_px.size(); ++i) {
    const int column = Clamp((points_px[i].x() - bounds.min_x) / kCellPx, columns_);
    const int row = Clamp((points_px[i].y() - bounds.min_y) / kCellPx, rows_);
    cells[i] = static_cast<uint32_t>(row * columns_ + column);
    ++starts_[cells[i] + 1];
  }
  for (size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
  std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (size_t i = 0; i < points_px.size(); ++i) indices_[next[cells[i]]++] = static_cast<uint32_t>(i);
}

}  // namespace yorb

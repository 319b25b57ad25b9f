// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/depth_cells.h"

#include <algorithm>
#include <cmath>

namespace yorb {

DepthCells::DepthCells(const DepthImage& depth) {
  if (depth.empty()) return;
  columns_ = depth.pixels.cols / kDepthCellPx;
  rows_ = depth.pixels.rows / kDepthCellPx;
  metres_.reserve(static_cast<size_t>(columns_) * static_cast<size_t>(rows_));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const int x = column * kDepthCellPx, y = row * kDepthCellPx;
      float metres = depth.At(x + 1, y + 1);
      if (metres <= 0) metres = depth.At(x + 3, y + 1);
      if (metres <= 0) metres = depth.At(x + 1, y + 3);
      metres_.push_back(metres > 0 ? metres : depth.At(x + 3, y + 3));
    }
  }
}

CellRange CellsOf(const Box& box, int columns, int rows, double margin_px) {
  const auto cell = [](double px, int most) {
    return static_cast<int>(std::clamp(px / kDepthCellPx, 0.0, static_cast<double>(most)));
  };
  return {cell(std::floor(box.left - margin_px), columns), cell(std::floor(box.top - margin_px), rows),
          cell(std::ceil(box.right + margin_px) + kDepthCellPx - 1, columns),
          cell(std::ceil(box.bottom + margin_px) + kDepthCellPx - 1, rows)};
}

}  // namespace yorb

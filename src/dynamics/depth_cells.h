// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "camera/image_set.h"
#include "detection/box.h"

namespace yorb {

/// Side of a cell in pixels: fine enough for an arm, and a sixteenth of the work.
constexpr int kDepthCellPx = 4;

/// A range of cells; right and bottom are behind the last.
struct CellRange {
  int left = 0, top = 0, right = 0, bottom = 0;
  int size() const { return right > left && bottom > top ? (right - left) * (bottom - top) : 0; }
  bool Holds(int column, int row) const { return column >= left && column < right && row >= top && row < bottom; }
};

/// The cells that a box, grown by `margin_px` on each side, covers in a picture of so many.
CellRange CellsOf(const Box& box, int columns, int rows, double margin_px = 0);

/// A depth picture at a quarter of its size: of each cell one measured pixel.
class DepthCells {
 public:
  explicit DepthCells(const DepthImage& depth);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  bool empty() const { return metres_.empty(); }

  /// Metres; 0 where nothing was measured.
  float At(int column, int row) const { return metres_[IndexOf(column, row)]; }
  size_t IndexOf(int column, int row) const {
    return static_cast<size_t>(row) * static_cast<size_t>(columns_) + static_cast<size_t>(column);
  }

  /// The cells that a box covers.
  CellRange RangeOf(const Box& box, double margin_px = 0) const { return CellsOf(box, columns_, rows_, margin_px); }

 private:
  int columns_ = 0, rows_ = 0;
  std::vector<float> metres_;
};

}  // namespace yorb

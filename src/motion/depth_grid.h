// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "camera/image_set.h"
#include "camera/rig.h"

namespace yorb {

/// Side of a cell in pixels of the ideal picture: as small as a hand some metres away, and as far as poses, rolling
/// shutters and the outlines in depth pictures may be off.
constexpr int kGridCellPx = 8;

/// A depth picture as coarse cells of the ideal picture.
struct DepthGrid {
  int columns = 0, rows = 0;
  std::vector<float> surface;  ///< metres; 0 where too little was measured, or an edge runs through the cell
  std::vector<float> free;     ///< metres up to which nothing is in the cell and about it; 0 where that is not known

  bool empty() const { return surface.empty(); }
  int size() const { return columns * rows; }

  /// The cell of an ideal pixel, or -1 outside.
  int CellAt(float x_px, float y_px) const {
    const float column = (x_px + 0.5f) / kGridCellPx, row = (y_px + 0.5f) / kGridCellPx;
    const bool is_inside =
        column >= 0 && row >= 0 && column < static_cast<float>(columns) && row < static_cast<float>(rows);
    return is_inside ? static_cast<int>(row) * columns + static_cast<int>(column) : -1;
  }
};

/// Makes grids of the depth pictures of one camera.
class DepthGridMaker {
 public:
  explicit DepthGridMaker(const Rig& rig);

  /// Empty where there is no depth picture of the rig's size. Pixels of what is known to move count as not measured;
  /// `moving`: CV_8UC1 at any scale, not 0 there; may be empty.
  DepthGrid Make(const DepthImage& depth, const cv::Mat& moving = {}) const;

 private:
  static constexpr int kSamples = 4;  ///< pixels that are read in a cell

  int width_, height_, columns_, rows_;
  std::vector<cv::Point> pixels_;  ///< of the picture as it is: kSamples a cell
};

}  // namespace yorb

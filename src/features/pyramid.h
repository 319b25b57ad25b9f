// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "features/grey_image.h"
#include "features/instructions.h"
#include "features/pyramid_rows.h"

namespace yorb {

/// Shrinks by bilinear interpolation with 8-bit weights, rounded to nearest: equal to the bit to
/// cv::resize(INTER_LINEAR_EXACT).
class Resizer {
 public:
  /// The result lives until the next call.
  GreyView Shrink(const GreyView& source, int width, int height, Instructions instructions);

 private:
  const int16_t* RowOf(const GreyView& source, int y, Instructions instructions);

  GreyImage target_;
  resize::Taps columns_, rows_;
  std::vector<int16_t> row_[2];  ///< source rows y, resized along x: row_[y % 2]
  int row_y_[2] = {-1, -1};
};

/// A picture in ever smaller sizes: level k is 1 / factor^k of the picture, made from level k - 1, as cv::ORB does.
class Pyramid {
 public:
  /// Levels of less than a pixel stay empty.
  void Build(const GreyView& picture, int levels, double factor, Instructions instructions);

  int levels() const { return static_cast<int>(views_.size()); }
  const GreyView& Level(int level) const { return views_[static_cast<size_t>(level)]; }

 private:
  GreyImage picture_;
  std::vector<Resizer> resizers_;  ///< of each level; they own its pixels
  std::vector<GreyView> views_;
};

}  // namespace yorb

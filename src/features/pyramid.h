// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "features/grey_image.h"
#include "features/instructions.h"

namespace yorb {

/// Where each pixel of a smaller row or column comes from: source pixels `first` and `first + 1` (clamped), weighted
/// 256 - weight and weight. Equal to OpenCV's INTER_LINEAR_EXACT.
struct ResizeTaps {
  int source_size = 0;
  std::vector<int> first;
  std::vector<uint16_t> weight;  ///< of the second pixel, in 1/256

  /// Does nothing when the sizes are the same as before.
  void Set(int source, int target);
};

/// Shrinks by bilinear interpolation with 8-bit weights, rounded to nearest: equal to the bit to
/// cv::resize(INTER_LINEAR_EXACT).
class Resizer {
 public:
  /// The result lives until the next call.
  GreyView Shrink(const GreyView& source, int width, int height, Instructions instructions);

 private:
  const uint16_t* RowOf(const GreyView& source, int y, Instructions instructions);

  GreyImage target_;
  ResizeTaps columns_, rows_;
  std::vector<uint16_t> row_[2];  ///< two source rows, resized along x, in 1/256 grey levels
  int row_y_[2] = {-1, -1};
};

/// A picture in ever smaller sizes: level k is 1 / factor^k of the picture, made from level k - 1, as cv::ORB does.
class Pyramid {
 public:
  /// Levels too small to hold a single keypoint are left empty.
  void Build(const GreyView& picture, int levels, double factor, Instructions instructions);

  int levels() const { return static_cast<int>(views_.size()); }
  const GreyView& Level(int level) const { return views_[static_cast<size_t>(level)]; }

 private:
  GreyImage picture_;
  std::vector<Resizer> resizers_;  ///< of each level; they own its pixels
  std::vector<GreyView> views_;
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace yorb {

/// A 3x3 convolution with padding 1, as Winograd's F(2x2, 3x3) or F(4x4, 3x3) does it: 4 outputs at a time from a patch
/// of 4x4 with 16 multiplications in place of 36, or 16 from a patch of 6x6 with 36 in place of 144. The
/// multiplications are products of matrices, one for each place in a patch, which the caller makes.
struct WinogradSize {
  int64_t height = 0, width = 0;  ///< of the picture, px
  int64_t in_channels = 0, out_channels = 0;
  int64_t pixel_step = 0;  ///< floats between pixels of the input
  int64_t tile = 2;        ///< outputs along each side of a patch: 2 or 4

  int64_t tiles_y() const { return (height + tile - 1) / tile; }
  int64_t tiles_x() const { return (width + tile - 1) / tile; }
  int64_t num_tiles() const { return tiles_y() * tiles_x(); }
  int64_t num_products() const { return (tile + 2) * (tile + 2); }
};

/// The tile for which there is least to do. Large tiles have more weights, which must meet enough patches to pay.
int64_t BestWinogradTile(int64_t height, int64_t width);

/// Weights in the order (out, in, 3, 3) to (products, out, in).
std::vector<float> WinogradWeights(const std::vector<float>& weights, const WinogradSize& size);

/// The picture, channels next to each other, to (products, tiles, in).
void WinogradInput(const WinogradSize& size, const float* picture, float* to);

/// What is put to each number at the end.
struct WinogradEnd {
  const float* bias = nullptr;  ///< one a channel; null: none
  float least = 0, most = 0;
};

/// The products, (products, tiles, out), to the picture, channels next to each other.
void WinogradOutput(const WinogradSize& size, const float* products, const WinogradEnd& end, float* picture);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace yorb {

/// A 3x3 convolution with padding 1, as Winograd's F(2x2, 3x3) does it: four outputs at a time from a patch of 4x4,
/// with 16 multiplications in place of 36. The multiplications are 16 products of matrices, which the caller makes.
struct WinogradSize {
  int64_t height = 0, width = 0;  ///< of the picture, px
  int64_t in_channels = 0, out_channels = 0;
  int64_t pixel_step = 0;  ///< floats between pixels of the input

  int64_t tiles_y() const { return (height + 1) / 2; }
  int64_t tiles_x() const { return (width + 1) / 2; }
  int64_t num_tiles() const { return tiles_y() * tiles_x(); }
};

constexpr int64_t kWinogradProducts = 16;

/// Weights in the order (out, in, 3, 3) to (16, out, in).
std::vector<float> WinogradWeights(const std::vector<float>& weights, int64_t out_channels, int64_t in_channels);

/// The picture, channels next to each other, to (16, tiles, in).
void WinogradInput(const WinogradSize& size, const float* picture, float* to);

/// What is put to each number at the end.
struct WinogradEnd {
  const float* bias = nullptr;  ///< one a channel; null: none
  float least = 0, most = 0;
};

/// The products, (16, tiles, out), to the picture, channels next to each other.
void WinogradOutput(const WinogradSize& size, const float* products, const WinogradEnd& end, float* picture);

}  // namespace yorb

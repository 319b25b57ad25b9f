// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace yorb::resize {

/// Rows are made in blocks: so many pixels beyond the end of a row are written.
constexpr int kBlock = 16;

/// Where each pixel of a smaller row comes from: source pixels `first` and `first + 1` (clamped), weighted 256 - weight
/// and weight. Equal to OpenCV's INTER_LINEAR_EXACT.
struct Taps {
  int source_size = 0, size = 0;
  std::vector<int> first;
  std::vector<int16_t> weight;  ///< of the second pixel, in 1/256; 0 also where there is no second pixel

  /// For each block of eight pixels: where its source bytes start, and which of the next 16 each pixel takes first and
  /// second, as byte shuffles into 16-bit lanes.
  std::vector<int> start;
  std::vector<uint8_t> first_lane, second_lane;
  bool fits_lanes = false;  ///< whether all blocks find their bytes within 16

  /// Does nothing when the sizes are the same as before.
  void Set(int source, int target);
};

/// A source row along x, in 1/256 grey levels, less 32768.
void RowPortable(const uint8_t* source, const Taps& taps, int16_t* out);
void RowAvx2(const uint8_t* source, const Taps& taps, int16_t* out);

/// Two such rows, one below the other, weighted 256 - weight and weight and rounded to grey levels.
void BetweenPortable(const int16_t* upper, const int16_t* lower, int weight, int width, uint8_t* out);
void BetweenAvx2(const int16_t* upper, const int16_t* lower, int weight, int width, uint8_t* out);

}  // namespace yorb::resize

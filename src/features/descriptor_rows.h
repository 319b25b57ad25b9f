// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace yorb::descriptor {

constexpr int kPatchRadius = 15;
/// Half the width of the round patch in the row so far above or below its centre; symmetric about the diagonals.
constexpr int kHalfWidth[kPatchRadius + 1] = {15, 15, 15, 15, 14, 14, 14, 13, 13, 12, 11, 10, 9, 8, 6, 3};

/// First moments of the grey values of the round patch about a pixel.
struct Moments {
  int x = 0, y = 0;
};
Moments MomentsPortable(const uint8_t* centre, ptrdiff_t stride);
Moments MomentsAvx2(const uint8_t* centre, ptrdiff_t stride);

/// The pattern turned by an angle, as distances in bytes from the centre: first pixel of each pair, then second.
struct Offsets {
  alignas(32) int32_t first[256];
  alignas(32) int32_t second[256];
};
void TurnPortable(float cosine, float sine, int stride, Offsets& offsets);
void TurnAvx2(float cosine, float sine, int stride, Offsets& offsets);

}  // namespace yorb::descriptor

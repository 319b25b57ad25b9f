// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace yorb::fast {

/// The ring of radius 3, clockwise from the top; pixel i + 8 is opposite to pixel i.
constexpr int kRing = 16;
constexpr int kRingX[kRing] = {0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3, -3, -3, -2, -1};
constexpr int kRingY[kRing] = {-3, -3, -2, -1, 0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3};

/// How many bytes beyond the end of a row are written and read: one block.
constexpr int kBlock = 32;

/// Which pixels of a row to score, and for what.
struct RowTask {
  const uint8_t* row = nullptr;  ///< pixel 0 of the row
  ptrdiff_t stride = 0;
  int begin = 0, end = 0;  ///< pixels; up to kBlock - 1 more are scored, with garbage
  int threshold = 0;       ///< scores below are 0
  int arc = 9;             ///< 9 to 12
};

/// Writes the score of pixel x to scores[x].
void ScoreRowPortable(const RowTask& task, uint8_t* scores);
void ScoreRowAvx2(const RowTask& task, uint8_t* scores);

/// Three rows of scores, one above the other.
struct ThreeRows {
  const uint8_t* above = nullptr;
  const uint8_t* here = nullptr;
  const uint8_t* below = nullptr;
};

/// Writes the x of all pixels, begin <= x < end, that score more than their eight neighbours; returns how many. `peaks`
/// has room for (end - begin + 1) / 2.
size_t PeaksPortable(const ThreeRows& scores, int begin, int end, uint32_t* peaks);
size_t PeaksAvx2(const ThreeRows& scores, int begin, int end, uint32_t* peaks);

/// The sum of the 16 ring pixels without the brightest and the darkest.
int TrimmedRingSumPortable(const uint8_t* centre, ptrdiff_t stride);
int TrimmedRingSumAvx2(const uint8_t* centre, ptrdiff_t stride);

}  // namespace yorb::fast

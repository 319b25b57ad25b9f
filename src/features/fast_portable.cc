// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstring>

#include "features/fast_rows.h"

namespace yorb::fast {
namespace {

/// Sixteen bytes in the vector notation that gcc and clang share: SSE2, NEON or what the processor has.
using Bytes = uint8_t __attribute__((vector_size(16)));
constexpr int kWidth = 16;

inline Bytes Load(const uint8_t* from) {
  Bytes bytes;
  std::memcpy(&bytes, from, sizeof(bytes));
  return bytes;
}
inline Bytes All(int value) { return Bytes{} + static_cast<uint8_t>(value); }
inline Bytes Min(Bytes a, Bytes b) { return a < b ? a : b; }
inline Bytes Max(Bytes a, Bytes b) { return a > b ? a : b; }
/// a - b, or 0 where b is larger.
inline Bytes Minus(Bytes a, Bytes b) { return Max(a, b) - b; }

inline bool IsZero(Bytes bytes) {
  uint64_t halves[2];
  std::memcpy(halves, &bytes, sizeof(halves));
  return (halves[0] | halves[1]) == 0;
}

/// An arc of nine or more holds one of any two opposite ring pixels: zero where some pairs rule out a corner.
inline Bytes MayBeCorner(const uint8_t* const ring[kRing], int x, Bytes centre, Bytes threshold) {
  Bytes least = All(255), most = All(0);
  for (int i = 0; i < kRing / 2; i += 2) {
    const Bytes a = Load(ring[i] + x), b = Load(ring[i + 8] + x);
    least = Min(least, Max(a, b));
    most = Max(most, Min(a, b));
  }
  return Max(Minus(Minus(least, centre), threshold), Minus(Minus(centre, most), threshold));
}

/// Scores of sixteen pixels: one less than the best arc's least difference, which is OpenCV's corner score.
inline Bytes ScoresAt(const uint8_t* const ring[kRing], int x, int arc, Bytes centre) {
  Bytes greatest_least = All(0), least_greatest = All(255);
  for (int first = 0; first < kRing; first += 2) {
    // The pixels that this arc and the next one share, then the ends in which they differ.
    Bytes low = Load(ring[first + 1] + x), high = low;
    for (int i = first + 2; i < first + arc; ++i) {
      const Bytes pixels = Load(ring[i % kRing] + x);
      low = Min(low, pixels);
      high = Max(high, pixels);
    }
    const Bytes start = Load(ring[first] + x), end = Load(ring[(first + arc) % kRing] + x);
    greatest_least = Max(greatest_least, Min(low, Max(start, end)));
    least_greatest = Min(least_greatest, Max(high, Min(start, end)));
  }
  return Max(Minus(greatest_least, centre), Minus(centre, least_greatest));
}

}  // namespace

void ScoreRowPortable(const RowTask& task, uint8_t* scores) {
  const uint8_t* ring[kRing];
  for (int i = 0; i < kRing; ++i) ring[i] = task.row + kRingY[i] * task.stride + kRingX[i];
  const Bytes threshold = All(task.threshold);
  for (int x = task.begin; x < task.end; x += kWidth) {
    const Bytes centre = Load(task.row + x);
    Bytes result = MayBeCorner(ring, x, centre, threshold);
    if (!IsZero(result)) {
      const Bytes contrast = ScoresAt(ring, x, task.arc, centre);
      result = contrast > threshold ? contrast - 1 : All(0);
    }
    std::memcpy(scores + x, &result, sizeof(result));
  }
}

size_t PeaksPortable(const ThreeRows& scores, int begin, int end, uint32_t* peaks) {
  size_t count = 0;
  const auto &above = scores.above, &here = scores.here, &below = scores.below;
  for (int x = begin; x < end; ++x) {
    const uint8_t score = here[x];
    if (score == 0 || score <= here[x - 1] || score <= here[x + 1]) continue;
    if (score <= std::max({above[x - 1], above[x], above[x + 1]})) continue;
    if (score > std::max({below[x - 1], below[x], below[x + 1]})) peaks[count++] = static_cast<uint32_t>(x);
  }
  return count;
}

int TrimmedRingSumPortable(const uint8_t* centre, ptrdiff_t stride) {
  int sum = 0, low = 255, high = 0;
  for (int i = 0; i < kRing; ++i) {
    const int pixel = centre[kRingY[i] * stride + kRingX[i]];
    sum += pixel;
    low = std::min(low, pixel);
    high = std::max(high, pixel);
  }
  return sum - low - high;
}

}  // namespace yorb::fast

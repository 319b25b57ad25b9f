// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/fast.h"

#include <algorithm>
#include <array>

#include "core/check.h"
#include "features/fast_rows.h"

namespace yorb {
namespace fast {
namespace {

using Block = uint8_t[kBlock];

/// Loops of fixed length over bytes, which compilers turn into wide instructions: a <- min or max (a, b).
inline void Lower(Block& a, const uint8_t* b) {
  for (int i = 0; i < kBlock; ++i) a[i] = std::min(a[i], b[i]);
}
inline void Raise(Block& a, const uint8_t* b) {
  for (int i = 0; i < kBlock; ++i) a[i] = std::max(a[i], b[i]);
}
inline void Copy(Block& a, const uint8_t* b) { std::copy(b, b + kBlock, a); }

/// Whether the quick look cannot rule out a corner in the block: an arc of nine or more holds one of any two opposite
/// ring pixels.
bool MayHoldCorner(const uint8_t* centre, const uint8_t* const ring[kRing], int threshold) {
  Block least, most, pair;
  std::fill(least, least + kBlock, uint8_t{255});
  std::fill(most, most + kBlock, uint8_t{0});
  for (int i = 0; i < kRing / 2; i += 2) {
    Copy(pair, ring[i]);
    Raise(pair, ring[i + 8]);
    Lower(least, pair);
    Copy(pair, ring[i]);
    Lower(pair, ring[i + 8]);
    Raise(most, pair);
  }
  int found = 0;
  for (int i = 0; i < kBlock; ++i) found |= (least[i] > centre[i] + threshold) | (most[i] < centre[i] - threshold);
  return found != 0;
}

/// The scores of one block: one less than the best arc's least difference, which is OpenCV's corner score.
void ScoreBlock(const uint8_t* centre, const uint8_t* const ring[kRing], const RowTask& task, uint8_t* scores) {
  Block greatest_least = {}, least_greatest, low, high;
  std::fill(least_greatest, least_greatest + kBlock, uint8_t{255});
  for (int first = 0; first < kRing; ++first) {
    Copy(low, ring[first]);
    Copy(high, ring[first]);
    for (int i = first + 1; i < first + task.arc; ++i) {
      Lower(low, ring[i % kRing]);
      Raise(high, ring[i % kRing]);
    }
    Raise(greatest_least, low);
    Lower(least_greatest, high);
  }
  for (int i = 0; i < kBlock; ++i) {
    const int contrast = std::max(greatest_least[i] - centre[i], centre[i] - least_greatest[i]);
    scores[i] = static_cast<uint8_t>(contrast > task.threshold ? contrast - 1 : 0);
  }
}

}  // namespace

void ScoreRowPortable(const RowTask& task, uint8_t* scores) {
  const uint8_t* ring[kRing];
  for (int x = task.begin; x < task.end; x += kBlock) {
    for (int i = 0; i < kRing; ++i) ring[i] = task.row + kRingY[i] * task.stride + kRingX[i] + x;
    if (MayHoldCorner(task.row + x, ring, task.threshold)) {
      ScoreBlock(task.row + x, ring, task, scores + x);
    } else {
      std::fill(scores + x, scores + x + kBlock, uint8_t{0});
    }
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

}  // namespace fast

int TrimmedRingSum(const GreyView& level, int x, int y) {
  int sum = 0, low = 255, high = 0;
  for (int i = 0; i < fast::kRing; ++i) {
    const int pixel = level.Row(y + fast::kRingY[i])[x + fast::kRingX[i]];
    sum += pixel;
    low = std::min(low, pixel);
    high = std::max(high, pixel);
  }
  return sum - low - high;
}

void Fast::ScoreRow(const GreyView& level, int y, const FastOptions& options, Instructions instructions) {
  const fast::RowTask task{level.Row(y),      level.stride, options.border - 1, level.width - options.border + 1,
                           options.threshold, options.arc};
  const auto score = instructions == Instructions::kAvx2 ? fast::ScoreRowAvx2 : fast::ScoreRowPortable;
  score(task, rows_[y % 3].data());
}

void Fast::TakePeaks(const GreyView& level, int y, const FastOptions& options, Instructions instructions) {
  const fast::ThreeRows rows{rows_[(y - 1) % 3].data(), rows_[y % 3].data(), rows_[(y + 1) % 3].data()};
  const auto find = instructions == Instructions::kAvx2 ? fast::PeaksAvx2 : fast::PeaksPortable;
  const size_t count = find(rows, options.border, level.width - options.border, peaks_.data());
  for (size_t i = 0; i < count; ++i)
    corners_.push_back({static_cast<int>(peaks_[i]), y, rows.here[peaks_[i]], 0.f, 0.f, 0.f});
}

const std::vector<Corner>& Fast::Detect(const GreyView& level, const FastOptions& options, Instructions instructions) {
  YORB_CHECK(options.border >= 4, "the ring of a corner and of its neighbours must lie inside of the picture");
  corners_.clear();
  if (level.width <= 2 * options.border || level.height <= 2 * options.border) return corners_;
  for (std::vector<uint8_t>& row : rows_) row.resize(static_cast<size_t>(level.width + 2 * fast::kBlock));
  peaks_.resize(static_cast<size_t>(level.width));
  ScoreRow(level, options.border - 1, options, instructions);
  ScoreRow(level, options.border, options, instructions);
  for (int y = options.border; y < level.height - options.border; ++y) {
    ScoreRow(level, y + 1, options, instructions);
    TakePeaks(level, y, options, instructions);
  }
  return corners_;
}

}  // namespace yorb

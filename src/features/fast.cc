// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/fast.h"

#include <algorithm>
#include <array>

#include "core/check.h"

namespace yorb {
namespace {

constexpr int kRing = 16;
/// The ring of radius 3, clockwise from the top.
constexpr int kRingX[kRing] = {0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3, -3, -3, -2, -1};
constexpr int kRingY[kRing] = {-3, -3, -2, -1, 0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3};

std::array<int, kRing> RingAt(const GreyView& level, int x, int y) {
  std::array<int, kRing> ring;
  for (size_t i = 0; i < kRing; ++i) ring[i] = level.Row(y + kRingY[i])[x + kRingX[i]];
  return ring;
}

/// Whether the quick look cannot rule out a corner: an arc of nine or more holds one of any two opposite ring pixels.
bool MayBeCorner(const std::array<int, kRing>& ring, int centre, int threshold) {
  bool brighter = true, darker = true;
  for (size_t i = 0; i < kRing / 2; ++i) {
    brighter = brighter && std::max(ring[i], ring[i + 8]) > centre + threshold;
    darker = darker && std::min(ring[i], ring[i + 8]) < centre - threshold;
  }
  return brighter || darker;
}

/// One less than the best arc's least difference: OpenCV's corner score.
int ScoreOf(const std::array<int, kRing>& ring, int centre, int arc) {
  int best = 0;
  for (size_t first = 0; first < kRing; ++first) {
    int brighter = 255, darker = 255;
    for (size_t i = first; i < first + static_cast<size_t>(arc); ++i) {
      brighter = std::min(brighter, ring[i % kRing] - centre);
      darker = std::min(darker, centre - ring[i % kRing]);
    }
    best = std::max({best, brighter, darker});
  }
  return std::max(best - 1, 0);
}

}  // namespace

int FastScore(const GreyView& level, int x, int y, int arc) {
  return ScoreOf(RingAt(level, x, y), level.Row(y)[x], arc);
}

int TrimmedRingSum(const GreyView& level, int x, int y) {
  const std::array<int, kRing> ring = RingAt(level, x, y);
  int sum = 0, low = 255, high = 0;
  for (const int pixel : ring) {
    sum += pixel;
    low = std::min(low, pixel);
    high = std::max(high, pixel);
  }
  return sum - low - high;
}

void Fast::ScoreRow(const GreyView& level, int y, const FastOptions& options, Instructions) {
  std::vector<uint8_t>& scores = rows_[y % 3];
  for (int x = options.border - 1; x <= level.width - options.border; ++x) {
    const std::array<int, kRing> ring = RingAt(level, x, y);
    const int centre = level.Row(y)[x];
    int score = 0;
    if (MayBeCorner(ring, centre, options.threshold)) score = ScoreOf(ring, centre, options.arc);
    scores[static_cast<size_t>(x)] = static_cast<uint8_t>(score >= options.threshold ? score : 0);
  }
}

void Fast::TakePeaks(const GreyView& level, int y, const FastOptions& options) {
  const uint8_t* above = rows_[(y - 1) % 3].data();
  const uint8_t* here = rows_[y % 3].data();
  const uint8_t* below = rows_[(y + 1) % 3].data();
  for (int x = options.border; x < level.width - options.border; ++x) {
    const int score = here[x];
    if (score == 0) continue;
    const int rival = std::max(
        {above[x - 1], above[x], above[x + 1], here[x - 1], here[x + 1], below[x - 1], below[x], below[x + 1]});
    if (score > rival) corners_.push_back({x, y, score, 0.f, 0.f, 0.f});
  }
}

const std::vector<Corner>& Fast::Detect(const GreyView& level, const FastOptions& options, Instructions instructions) {
  YORB_CHECK(options.border >= 4, "the ring of a corner and of its neighbours must lie inside of the picture");
  corners_.clear();
  if (level.width <= 2 * options.border || level.height <= 2 * options.border) return corners_;
  for (std::vector<uint8_t>& row : rows_) row.assign(static_cast<size_t>(level.width), 0);
  ScoreRow(level, options.border - 1, options, instructions);
  ScoreRow(level, options.border, options, instructions);
  for (int y = options.border; y < level.height - options.border; ++y) {
    ScoreRow(level, y + 1, options, instructions);
    TakePeaks(level, y, options);
  }
  return corners_;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/fast.h"

#include <algorithm>

#include "core/check.h"
#include "features/fast_rows.h"

namespace yorb {
namespace {

/// Where between -0.5 and 0.5 the parabola through three scores has its top.
float Top(int before, int here, int after) {
  const int bend = 2 * here - before - after;
  if (bend <= 0) return 0;
  return std::clamp(static_cast<float>(after - before) / static_cast<float>(2 * bend), -0.5f, 0.5f);
}

}  // namespace

Corner Refined(Corner corner) {
  corner.dx = Top(corner.beside.left, corner.score, corner.beside.right);
  corner.dy = Top(corner.beside.above, corner.score, corner.beside.below);
  return corner;
}

int TrimmedRingSum(const GreyView& level, int x, int y, Instructions instructions) {
  const auto sum = instructions == Instructions::kAvx2 ? fast::TrimmedRingSumAvx2 : fast::TrimmedRingSumPortable;
  return sum(level.Row(y) + x, level.stride);
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
  for (size_t i = 0; i < count; ++i) {
    const uint32_t x = peaks_[i];
    const NeighbourScores beside{rows.here[x - 1], rows.here[x + 1], rows.above[x], rows.below[x]};
    corners_.push_back({static_cast<int>(x), y, rows.here[x], 0.f, 0.f, 0.f, beside});
  }
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

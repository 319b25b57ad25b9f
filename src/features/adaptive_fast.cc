// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/adaptive_fast.h"

#include <algorithm>
#include <cmath>

namespace yorb {
namespace {

constexpr int kCellPx = 30;
constexpr int kOne = 4096;  ///< of the fixed-point alphas

/// The cells of a level: as many whole ones as fit into what the border leaves, a little larger than kCellPx.
struct Cells {
  int border, columns, rows, width, height;

  Cells(const GreyView& level, int border_px) : border(border_px) {
    const int inner_width = level.width - 2 * border, inner_height = level.height - 2 * border;
    columns = std::max(1, inner_width / kCellPx);
    rows = std::max(1, inner_height / kCellPx);
    width = (inner_width + columns - 1) / columns;
    height = (inner_height + rows - 1) / rows;
  }
  uint32_t Of(const Corner& corner) const {
    return static_cast<uint32_t>((corner.y - border) / height * columns + (corner.x - border) / width);
  }
};

/// Which thresholds a corner passes, in whole numbers: score + 1 > alpha * ring / 14.
class Thresholds {
 public:
  explicit Thresholds(const CornerOptions& options)
      : options_(options),
        first_(static_cast<int64_t>(std::lround(options.alpha * kOne))),
        second_(static_cast<int64_t>(std::lround(options.alpha_low * kOne))) {}

  bool PassesFirst(int score, int ring) const {
    return options_.is_adaptive ? Exceeds(score, first_, ring) : score >= options_.high;
  }
  bool PassesSecond(int score, int ring) const {
    return options_.is_adaptive ? Exceeds(score, second_, ring) : score >= options_.low;
  }
  int Lowest() const { return options_.is_adaptive ? options_.noise : std::min(options_.low, options_.high); }

 private:
  static bool Exceeds(int score, int64_t alpha, int ring) { return int64_t{score + 1} * 14 * kOne > alpha * ring; }

  const CornerOptions& options_;
  int64_t first_, second_;
};

}  // namespace

const std::vector<Corner>& CornerDetector::Detect(const GreyView& level, const CornerOptions& options,
                                                  Instructions instructions) {
  corners_.clear();
  if (level.width <= 2 * options.border || level.height <= 2 * options.border) return corners_;
  const Thresholds thresholds(options);
  const Cells cells(level, options.border);
  firsts_.assign(static_cast<size_t>(cells.columns * cells.rows), 0);
  candidates_.clear();
  cells_.clear();
  is_first_.clear();
  for (Corner corner : fast_.Detect(level, {thresholds.Lowest(), options.arc, options.border}, instructions)) {
    const int ring = options.is_adaptive ? TrimmedRingSum(level, corner.x, corner.y) : 0;
    const bool is_first = thresholds.PassesFirst(corner.score, ring);
    if (!is_first && !thresholds.PassesSecond(corner.score, ring)) continue;
    corner.response = static_cast<float>(corner.score);
    candidates_.push_back(corner);
    cells_.push_back(cells.Of(corner));
    is_first_.push_back(is_first);
    firsts_[cells_.back()] += is_first;
  }
  for (size_t i = 0; i < candidates_.size(); ++i) {
    if (is_first_[i] || firsts_[cells_[i]] == 0) corners_.push_back(candidates_[i]);
  }
  return corners_;
}

}  // namespace yorb

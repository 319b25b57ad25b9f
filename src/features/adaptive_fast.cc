// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/adaptive_fast.h"

#include <algorithm>
#include <cmath>

namespace yorb {
namespace {

constexpr int kCellPx = 30;
constexpr int kOne = 4096;  ///< of the fixed-point alphas

/// The cells of a level along one axis: as many whole ones as fit into what the border leaves, a little larger than
/// kCellPx.
struct CellAxis {
  int count, size;

  CellAxis(int length, int border) : count(std::max(1, (length - 2 * border) / kCellPx)) {
    size = (length - 2 * border + count - 1) / count;
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

 private:
  static bool Exceeds(int score, int64_t alpha, int ring) { return int64_t{score + 1} * 14 * kOne > alpha * ring; }

  const CornerOptions& options_;
  int64_t first_, second_;
};

}  // namespace

void CornerDetector::Classify(const std::vector<Corner>& found, const GreyView& level, const CornerOptions& options,
                              Instructions instructions) {
  const Thresholds thresholds(options);
  classes_.clear();
  for (const Corner& corner : found) {
    const int ring = options.is_adaptive ? TrimmedRingSum(level, corner.x, corner.y, instructions) : 0;
    classes_.push_back(thresholds.PassesFirst(corner.score, ring)    ? Class::kFirst
                       : thresholds.PassesSecond(corner.score, ring) ? Class::kSecond
                                                                     : Class::kNoise);
  }
}

size_t CornerDetector::ChooseByCells(const std::vector<Corner>& found, const GreyView& level, int border) {
  const CellAxis columns(level.width, border), rows(level.height, border);
  column_cells_.resize(static_cast<size_t>(level.width));
  for (int x = border; x < level.width - border; ++x) {
    column_cells_[static_cast<size_t>(x)] = static_cast<uint32_t>((x - border) / columns.size);
  }
  has_first_.assign(static_cast<size_t>(columns.count * rows.count), 0);
  cells_.clear();
  for (size_t i = 0; i < found.size(); ++i) {
    const int row = (found[i].y - border) / rows.size;
    cells_.push_back(static_cast<uint32_t>(row * columns.count) + column_cells_[static_cast<size_t>(found[i].x)]);
    if (classes_[i] == Class::kFirst) has_first_[cells_[i]] = 1;
  }
  size_t chosen = 0;
  for (size_t i = 0; i < found.size(); ++i) {
    const bool is_chosen = classes_[i] == Class::kFirst || (classes_[i] == Class::kSecond && !has_first_[cells_[i]]);
    if (is_chosen) classes_[i] = Class::kChosen;
    chosen += is_chosen;
  }
  return chosen;
}

void CornerDetector::ChooseStrongest(const std::vector<Corner>& found, size_t count) {
  rest_.clear();
  for (uint32_t i = 0; i < found.size(); ++i) {
    if (classes_[i] != Class::kChosen) rest_.push_back(i);
  }
  count = std::min(count, rest_.size());
  // Those that pass the second threshold first.
  std::partial_sort(rest_.begin(), rest_.begin() + static_cast<ptrdiff_t>(count), rest_.end(),
                    [&](uint32_t a, uint32_t b) {
                      if (classes_[a] != classes_[b]) return classes_[a] > classes_[b];
                      return found[a].score != found[b].score ? found[a].score > found[b].score : a < b;
                    });
  for (size_t i = 0; i < count; ++i) classes_[rest_[i]] = Class::kChosen;
}

const std::vector<Corner>& CornerDetector::Detect(const GreyView& level, const CornerOptions& options, int enough,
                                                  Instructions instructions) {
  corners_.clear();
  const int lowest = options.is_adaptive ? options.noise : std::min(options.low, options.high);
  const std::vector<Corner>& found = fast_.Detect(level, {lowest, options.arc, options.border}, instructions);
  if (found.empty()) return corners_;
  Classify(found, level, options, instructions);
  const size_t chosen = ChooseByCells(found, level, options.border), wanted = static_cast<size_t>(std::max(enough, 0));
  if (options.is_adaptive && chosen < wanted) ChooseStrongest(found, wanted - chosen);
  for (size_t i = 0; i < found.size(); ++i) {
    if (classes_[i] != Class::kChosen) continue;
    corners_.push_back(found[i]);
    corners_.back().response = static_cast<float>(found[i].score);
  }
  return corners_;
}

const std::vector<Corner>& CornerDetector::DetectFirst(const GreyView& level, const CornerOptions& options,
                                                       Instructions instructions) {
  corners_.clear();
  const int lowest = options.is_adaptive ? options.noise : options.high;
  const std::vector<Corner>& found = fast_.Detect(level, {lowest, options.arc, options.border}, instructions);
  Classify(found, level, options, instructions);
  for (size_t i = 0; i < found.size(); ++i) {
    if (classes_[i] != Class::kFirst) continue;
    corners_.push_back(found[i]);
    corners_.back().response = static_cast<float>(found[i].score);
  }
  return corners_;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/adaptive_fast.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>

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

void CornerDetector::FindCells(const std::vector<Corner>& found, const GreyView& level, int border) {
  const CellAxis columns(level.width, border), rows(level.height, border);
  // A table of columns spares a division for each corner; rows change seldom.
  column_cells_.resize(static_cast<size_t>(level.width));
  for (int x = border; x < level.width - border; ++x) {
    column_cells_[static_cast<size_t>(x)] = static_cast<uint32_t>((x - border) / columns.size);
  }
  cells_.clear();
  int y = -1;
  uint32_t row_start = 0;
  for (const Corner& corner : found) {
    if (corner.y != y) {
      y = corner.y;
      row_start = static_cast<uint32_t>((y - border) / rows.size * columns.count);
    }
    cells_.push_back(row_start + column_cells_[static_cast<size_t>(corner.x)]);
  }
}

size_t CornerDetector::ChooseByCells(const std::vector<Corner>& found, const GreyView& level, int border) {
  FindCells(found, level, border);
  has_first_.assign(static_cast<size_t>(CellAxis(level.width, border).count * CellAxis(level.height, border).count), 0);
  for (size_t i = 0; i < found.size(); ++i) {
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

void CornerDetector::MeasureStrength(const std::vector<Corner>& found, const GreyView& level, int border) {
  const CellAxis columns(level.width, border), rows(level.height, border);
  struct Sums {
    float scores = 0, squares = 0;
  };
  std::vector<Sums> sums(static_cast<size_t>(columns.count * rows.count));
  FindCells(found, level, border);
  for (size_t i = 0; i < found.size(); ++i) {
    Sums& sum = sums[cells_[i]];
    sum.scores += static_cast<float>(found[i].score);
    sum.squares += static_cast<float>(found[i].score * found[i].score);
  }
  // The mean score of a cell and its eight neighbours, each corner weighted by its score: the weak ones, which come and
  // go with the light, hardly count.
  std::vector<float> typical(sums.size());
  for (int row = 0; row < rows.count; ++row) {
    for (int column = 0; column < columns.count; ++column) {
      Sums around;
      for (int y = std::max(0, row - 1); y <= std::min(rows.count - 1, row + 1); ++y) {
        for (int x = std::max(0, column - 1); x <= std::min(columns.count - 1, column + 1); ++x) {
          const Sums& sum = sums[static_cast<size_t>(y * columns.count + x)];
          around.scores += sum.scores, around.squares += sum.squares;
        }
      }
      typical[static_cast<size_t>(row * columns.count + column)] =
          around.squares > 0 ? around.scores / around.squares : 1.f;
    }
  }
  strength_.clear();
  for (size_t i = 0; i < found.size(); ++i) {
    strength_.push_back(static_cast<float>(found[i].score) * typical[cells_[i]]);
  }
}

void CornerDetector::ChooseByStrength(const std::vector<Corner>& found, const GreyView& level,
                                      const CornerOptions& options, size_t enough, Instructions instructions) {
  MeasureStrength(found, level, options.border);
  ranks_.clear();
  for (size_t i = 0; i < found.size(); ++i) {
    uint32_t bits;  // of positive floats rise with their value
    std::memcpy(&bits, &strength_[i], sizeof bits);
    ranks_.push_back(uint64_t{bits} << 32 | (UINT32_MAX - static_cast<uint32_t>(i)));
  }
  const size_t asked =
      std::min(found.size(), static_cast<size_t>(static_cast<double>(enough) * std::max(1.0, options.choice)));
  std::nth_element(ranks_.begin(), ranks_.begin() + static_cast<ptrdiff_t>(asked), ranks_.end(), std::greater<>());
  ranks_.resize(asked);
  const Thresholds thresholds(options);
  classes_.assign(found.size(), Class::kNoise);
  size_t num_chosen = 0;
  refused_.clear();
  for (const uint64_t rank : ranks_) {
    const uint32_t i = UINT32_MAX - static_cast<uint32_t>(rank);
    const bool passes =
        thresholds.PassesSecond(found[i].score, TrimmedRingSum(level, found[i].x, found[i].y, instructions));
    if (passes) classes_[i] = Class::kChosen;
    num_chosen += passes;
    if (!passes) refused_.push_back(rank);
  }
  if (num_chosen >= enough) return;
  std::sort(refused_.begin(), refused_.end(), std::greater<>());
  refused_.resize(std::min(refused_.size(), enough - num_chosen));
  for (const uint64_t rank : refused_) classes_[UINT32_MAX - static_cast<uint32_t>(rank)] = Class::kChosen;
}

/// Those that are chosen, ranked by `strength_`.
void CornerDetector::TakeCorners(const std::vector<Corner>& found) {
  for (size_t i = 0; i < found.size(); ++i) {
    if (classes_[i] != Class::kChosen) continue;
    corners_.push_back(found[i]);
    corners_.back().response = strength_[i];
  }
}

const std::vector<Corner>& CornerDetector::Detect(const GreyView& level, const CornerOptions& options, int enough,
                                                  Instructions instructions, const CornerFilter& may_use) {
  const int lowest = options.is_adaptive ? options.noise : std::min(options.low, options.high);
  fast_.Detect(level, {lowest, options.arc, options.border}, instructions);
  return DetectAgain(level, options, enough, instructions, may_use);
}

const std::vector<Corner>& CornerDetector::DetectAgain(const GreyView& level, const CornerOptions& options, int enough,
                                                       Instructions instructions, const CornerFilter& may_use) {
  corners_.clear();
  const std::vector<Corner>& all = fast_.found();
  if (may_use) {
    usable_.clear();
    std::copy_if(all.begin(), all.end(), std::back_inserter(usable_), may_use);
  }
  const std::vector<Corner>& found = may_use ? usable_ : all;
  if (found.empty()) return corners_;
  const size_t wanted = static_cast<size_t>(std::max(enough, 0));
  if (options.is_adaptive && options.choice > 0) {
    ChooseByStrength(found, level, options, wanted, instructions);
  } else {
    Classify(found, level, options, instructions);
    const size_t chosen = ChooseByCells(found, level, options.border);
    if (options.is_adaptive && chosen < wanted) ChooseStrongest(found, wanted - chosen);
    strength_.clear();
    for (const Corner& corner : found) strength_.push_back(static_cast<float>(corner.score));
  }
  TakeCorners(found);
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

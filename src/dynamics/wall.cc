// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/wall.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace yorb {
namespace {

constexpr int kBesideCells = 8;       // how far to look for the wall beside a box
constexpr int kLeastBeside = 3;       // measured cells on each side
constexpr float kFarM = 5;            // beyond it, noise hides a body before a wall
constexpr float kOffM = 0.03f;        // from the wall: a frame, a fold of paper,
constexpr float kNoise = 0.005f;      // and more far away, 1/m
constexpr float kLeastJudged = 0.4f;  // of all cells, those that are measured between two that show the wall
constexpr float kLeastOn = 0.85f;     // of these, on the wall: the rest may be what hangs before it
constexpr float kLeastCells = 24;

/// A row or a column of cells through a box and its surroundings.
class Line {
 public:
  Line(const BodySearch& search, bool is_row, int index) : search_(search), is_row_(is_row), index_(index) {}

  int size() const { return is_row_ ? search_.depth.columns() : search_.depth.rows(); }

  /// Metres; 0 where nothing was measured or something else is known to be.
  float At(int i) const {
    const int column = is_row_ ? i : index_, row = is_row_ ? index_ : i;
    return search_.taken[search_.depth.IndexOf(column, row)] == kBody ? 0 : search_.depth.At(column, row);
  }
  bool IsInABox(int i) const { return is_row_ ? search_.IsInABox(i, index_) : search_.IsInABox(index_, i); }

 private:
  const BodySearch& search_;
  bool is_row_;
  int index_;
};

/// A place on a line, cells, and what is measured there, 1/m.
struct Mark {
  float place, inverse_depth;
};

/// The mean of the first measured cells from `begin` on, which go away from the box by `step`.
std::optional<Mark> Beside(const Line& line, int begin, int step) {
  Mark sum{0, 0};
  float count = 0;
  for (int i = begin; i != begin + step * kBesideCells && i >= 0 && i < line.size(); i += step) {
    const float metres = line.At(i);
    if (metres <= 0 || line.IsInABox(i)) continue;
    sum.place += static_cast<float>(i), sum.inverse_depth += 1 / metres, ++count;
  }
  if (count < kLeastBeside) return std::nullopt;
  return Mark{sum.place / count, sum.inverse_depth / count};
}

/// How many cells there are, how many of them are measured between two marks, and how many of these lie on the line
/// through the marks: the inverse depth of a plane is affine in the picture.
struct Count {
  float all = 0, judged = 0, on = 0;
};

void Judge(const Line& line, int begin, int end, Count& count) {
  const auto before = Beside(line, begin - 1 - kInexactCells, -1), behind = Beside(line, end + kInexactCells, 1);
  count.all += static_cast<float>(end - begin);
  if (!before || !behind) return;
  for (int i = begin; i < end; ++i) {
    const float metres = line.At(i);
    if (metres <= 0) continue;
    const float share = (static_cast<float>(i) - before->place) / (behind->place - before->place);
    const float wall = 1 / (before->inverse_depth + share * (behind->inverse_depth - before->inverse_depth));
    ++count.judged;
    if (wall < kFarM && std::abs(metres - wall) < kOffM + kNoise * wall * wall) ++count.on;
  }
}

bool IsWall(const Count& count) {
  return count.judged >= kLeastCells && count.judged >= kLeastJudged * count.all && count.on >= kLeastOn * count.judged;
}

}  // namespace

bool LiesInAWall(const BodySearch& search, const Box& box) {
  if (search.depth.empty()) return false;
  const CellRange range = search.depth.RangeOf(box);
  Count across, along;
  for (int row = range.top; row < range.bottom; ++row) {
    Judge(Line(search, true, row), range.left, range.right, across);
  }
  if (IsWall(across)) return true;
  for (int column = range.left; column < range.right; ++column) {
    Judge(Line(search, false, column), range.top, range.bottom, along);
  }
  return IsWall(along);
}

}  // namespace yorb

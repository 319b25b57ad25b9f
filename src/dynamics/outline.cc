// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/outline.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace yorb {
namespace {

constexpr double kLookAround = 0.5;  // how far around a box to look, of its sides
constexpr float kStepM = 0.06f;      // from cell to cell on one surface: the slant of a wall,
constexpr float kNoise = 0.02f;      // and more far away, 1/m
constexpr int kLeastBodyCells = 24;  // of a body, to say anything
constexpr double kGoesOn = 0.5;      // as much outside, of what is within

bool IsIn(const CellRange& range, int column, int row) {
  return column >= range.left && column < range.right && row >= range.top && row < range.bottom;
}

/// How many cells of the surface of a body lie within its box, and beyond it.
class Surface {
 public:
  Surface(const BodySearch& search, const Box& box, const BodyPlane& body)
      : search_(search),
        body_(body),
        box_(search.depth.RangeOf(box)),
        near_(search.depth.RangeOf(box, kInexactCells * kDepthCellPx)),
        all_(search.depth.RangeOf(box, kLookAround * std::max(box.width(), box.height()))),
        is_seen_(static_cast<size_t>(all_.size()), false) {
    for (int row = box_.top; row < box_.bottom; ++row) {
      for (int column = box_.left; column < box_.right; ++column) {
        if (IsBody(column, row)) Take(column, row);
      }
    }
    num_within_ = edge_.size();
    Spread();
  }

  size_t num_within() const { return num_within_; }
  size_t num_beyond() const { return num_beyond_; }

 private:
  bool IsBody(int column, int row) const {
    return search_.taken[search_.depth.IndexOf(column, row)] == 0 &&
           body_.Holds(column, row, search_.depth.At(column, row));
  }

  std::vector<bool>::reference IsSeen(int column, int row) {
    return is_seen_[static_cast<size_t>((row - all_.top) * (all_.right - all_.left) + column - all_.left)];
  }

  void Take(int column, int row) {
    IsSeen(column, row) = true;
    edge_.emplace_back(column, row);
  }

  void Spread() {
    constexpr std::pair<int, int> kSteps[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    while (!edge_.empty()) {
      const auto [column, row] = edge_.back();
      edge_.pop_back();
      const float here = search_.depth.At(column, row);
      for (const auto& [dx, dy] : kSteps) {
        const int x = column + dx, y = row + dy;
        if (!IsIn(all_, x, y) || IsSeen(x, y) || IsIn(box_, x, y) || !IsBody(x, y)) continue;
        if (std::abs(search_.depth.At(x, y) - here) > kStepM + kNoise * here * here) continue;
        Take(x, y);
        if (!IsIn(near_, x, y) && !search_.IsInABox(x, y)) ++num_beyond_;
      }
    }
  }

  const BodySearch& search_;
  const BodyPlane& body_;
  CellRange box_, near_, all_;
  std::vector<bool> is_seen_;
  std::vector<std::pair<int, int>> edge_;
  size_t num_within_ = 0, num_beyond_ = 0;
};

}  // namespace

bool GoesOnBeyond(const BodySearch& search, const Box& box, const BodyPlane& body) {
  const Surface surface(search, box, body);
  return surface.num_within() >= kLeastBodyCells &&
         static_cast<double>(surface.num_beyond()) > kGoesOn * static_cast<double>(surface.num_within());
}

}  // namespace yorb

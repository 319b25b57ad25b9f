// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/outline.h"

#include <cmath>

namespace yorb {
namespace {

/// Counts how a surface crosses the borders of a box.
class Crossings {
 public:
  Crossings(const BodySearch& search, const BodyPlane& body) : search_(search), body_(body) {}

  /// Looks from a cell just within the box outwards.
  void Look(int column, int row, int out_x, int out_y) {
    constexpr int kOut = 2;  // cells, as boxes are not exact
    const int x = column + kOut * out_x, y = row + kOut * out_y;
    if (x < 0 || x >= search_.depth.columns() || y < 0 || y >= search_.depth.rows() || search_.IsInABox(x, y)) return;
    const float within = search_.depth.At(column, row), beyond = search_.depth.At(x, y);
    if (within <= 0 || beyond <= 0) return;
    ++num_seen_;
    num_on_ += IsUnbroken(column, row, within, beyond);
  }

  /// Whether enough was seen, and it goes on across most of it.
  bool MostGoOn() const {
    constexpr int kLeast = 12;
    return num_seen_ >= kLeast && 2 * num_on_ > num_seen_;
  }

 private:
  /// Whether the surface at a cell is the body's and goes on to the next depth: a step of a few centimetres, and more
  /// far away, is the slant of a wall.
  bool IsUnbroken(int column, int row, float within, float beyond) const {
    constexpr float kOnM = 0.3f, kStepM = 0.06f, kNoise = 0.02f;
    const bool is_on = std::abs(within - body_.DepthAt(column, row)) < kOnM;
    return is_on && std::abs(beyond - within) < kStepM + kNoise * within * within;
  }

  const BodySearch& search_;
  const BodyPlane& body_;
  int num_seen_ = 0, num_on_ = 0;
};

}  // namespace

bool GoesOnBeyond(const BodySearch& search, const Box& box, const BodyPlane& body) {
  const CellRange range = search.depth.RangeOf(box);
  Crossings crossings(search, body);
  for (int row = range.top; row < range.bottom; ++row) {
    crossings.Look(range.left, row, -1, 0);
    crossings.Look(range.right - 1, row, 1, 0);
  }
  for (int column = range.left; column < range.right; ++column) {
    crossings.Look(column, range.top, 0, -1);
    crossings.Look(column, range.bottom - 1, 0, 1);
  }
  return crossings.MostGoOn();
}

}  // namespace yorb

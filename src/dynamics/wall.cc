// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/wall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace yorb {
namespace {

constexpr float kFarM = 5;                   // beyond it, noise hides a body before a wall
constexpr float kOffM = 0.03f;               // from the wall: a frame, a fold of paper,
constexpr float kNoise = 0.005f;             // and more far away, 1/m
constexpr float kLeastWallCells = 24;        // measured in the box
constexpr float kLeastShareMeasured = 0.4f;  // of its cells
constexpr float kLeastOn = 0.85f;            // of what is measured: the rest may be what hangs before the wall
constexpr int kBesideCells = 8;              // how far beyond a box to look for the wall
constexpr float kLeastBeside = 0.3f;         // of the cells of one side, measured: fewer say nothing
constexpr float kMostBehind = 0.3f;          // of these, behind the wall: that is how a body ends

/// Metres measured in a cell; 0 for none, or where a body is known to be.
float MetresAt(const BodySearch& search, int column, int row) {
  return search.taken[search.depth.IndexOf(column, row)] == kBody ? 0 : search.depth.At(column, row);
}

/// How far behind a wall a measured depth is, in units of what it may be off; before it where negative.
float Behind(const CellPlane& wall, int column, int row, float metres) {
  const float there = 1 / std::max(wall.InverseDepthAt(column, row), 1 / kFarM);
  return (metres - there) / (kOffM + kNoise * there * there);
}

bool Holds(const CellPlane& wall, int column, int row, float metres) {
  return wall.InverseDepthAt(column, row) > 1 / kFarM && std::abs(Behind(wall, column, row, metres)) < 1;
}

/// The plane through most of what is measured in a range: each turn takes in what lies near that of the turn before,
/// the first one everything.
CellPlane FitWall(const BodySearch& search, const CellRange& range) {
  constexpr std::array<float, 4> kNear = {std::numeric_limits<float>::infinity(), 3, 1, 1};
  constexpr float kStiffness = 1e-5f;
  CellPlane wall;
  for (const float near : kNear) {
    CellPlaneFit fit(range);
    for (int row = range.top; row < range.bottom; ++row) {
      for (int column = range.left; column < range.right; ++column) {
        const float metres = MetresAt(search, column, row);
        if (metres > 0 && std::abs(Behind(wall, column, row, metres)) <= near) fit.Add(column, row, metres);
      }
    }
    if (fit.weight() < kLeastWallCells) break;
    wall = fit.Solve(kStiffness);
  }
  return wall;
}

/// How many cells are measured, and where they lie.
struct Count {
  float measured = 0, on = 0, behind = 0;
};

/// `is_beside`: of the cells in other boxes, which may be those of bodies, only what lies on the wall counts.
Count CountIn(const BodySearch& search, const CellPlane& wall, const CellRange& range, bool is_beside) {
  Count count;
  for (int row = std::max(0, range.top); row < std::min(range.bottom, search.depth.rows()); ++row) {
    for (int column = std::max(0, range.left); column < std::min(range.right, search.depth.columns()); ++column) {
      const float metres = MetresAt(search, column, row);
      if (metres <= 0) continue;
      const bool is_on = Holds(wall, column, row, metres);
      if (is_beside && !is_on && search.IsInABox(column, row)) continue;
      ++count.measured;
      if (is_on) {
        ++count.on;
      } else if (Behind(wall, column, row, metres) > 0) {
        ++count.behind;
      }
    }
  }
  return count;
}

bool IsOn(const Count& count) { return count.on >= kLeastOn * count.measured; }

}  // namespace

bool LiesInAWall(const BodySearch& search, const Box& box) {
  if (search.depth.empty()) return false;
  const CellRange range = search.depth.RangeOf(box);
  const CellPlane wall = FitWall(search, range);
  const Count inside = CountIn(search, wall, range, false);
  const float least = std::max(kLeastWallCells, kLeastShareMeasured * static_cast<float>(range.size()));
  if (inside.measured < least || !IsOn(inside)) return false;

  constexpr int kFrom = kInexactCells, kTo = kInexactCells + kBesideCells;
  const std::array<CellRange, 4> sides = {{{range.left - kTo, range.top, range.left - kFrom, range.bottom},
                                           {range.right + kFrom, range.top, range.right + kTo, range.bottom},
                                           {range.left, range.top - kTo, range.right, range.top - kFrom},
                                           {range.left, range.bottom + kFrom, range.right, range.bottom + kTo}}};
  bool goes_on = false;
  for (const CellRange& side : sides) {
    const bool is_below = side.top > range.bottom;  // a body, too, goes on below a box that cuts it
    const Count beside = CountIn(search, wall, side, true);
    if (beside.measured < kLeastBeside * static_cast<float>(side.size())) continue;
    if (beside.behind > kMostBehind * beside.measured) return false;
    goes_on = goes_on || (!is_below && IsOn(beside));
  }
  return goes_on;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/body.h"

#include <algorithm>
#include <array>
#include <utility>

namespace yorb {
namespace {

constexpr double kGrow = 0.1;          // of the box, on each side
constexpr float kLeastAround = 0.25f;  // of the cells of a box, so that its surroundings have their full say
constexpr int kStep = 2;               // cells, in sums that need not be finer

/// Cells that were measured, and how many of them are at a body.
struct Counts {
  float measured = 0, on_body = 0;

  void Add(bool is_on) { ++measured, on_body += is_on ? 1.f : 0.f; }
};

/// Marks what hangs together with the cells of `edge` at the body's depth, within `range`.
void Spread(CellMask& mask, const DepthCells& depth, const CellRange& range, const BodyPlane& body,
            std::vector<std::pair<int, int>> edge) {
  constexpr std::pair<int, int> kSteps[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  while (!edge.empty()) {
    const auto [column, row] = edge.back();
    edge.pop_back();
    for (const auto& [dx, dy] : kSteps) {
      const int x = column + dx, y = row + dy;
      if (!range.Holds(x, y)) continue;
      uint8_t& cell = mask[depth.IndexOf(x, y)];
      const float metres = depth.At(x, y);
      if (cell != 0 || !body.Holds(x, y, metres)) continue;
      cell = kBody;
      edge.emplace_back(x, y);
    }
  }
}

/// Whether a measured cell near this one is body, or none near it was measured at all.
bool MayBeBody(const CellMask& mask, const DepthCells& depth, int column, int row) {
  constexpr int kReach = 3;
  bool was_measured = false;
  for (int y = std::max(row - kReach, 0); y <= std::min(row + kReach, depth.rows() - 1); ++y) {
    for (int x = std::max(column - kReach, 0); x <= std::min(column + kReach, depth.columns() - 1); ++x) {
      if (depth.At(x, y) <= 0) continue;
      if (mask[depth.IndexOf(x, y)] == kBody) return true;
      was_measured = true;
    }
  }
  return !was_measured;
}

}  // namespace

CellMask CellsInBoxes(const DepthCells& depth, const std::vector<Box>& boxes) {
  CellMask mask(depth.IndexOf(0, depth.rows()), 0);
  const auto middle = [](int cell) { return (cell + 0.5) * kDepthCellPx; };
  for (const Box& box : boxes) {
    CellRange range = depth.RangeOf(box);  // these cells, and at the edges some whose middles are outside
    while (range.left < range.right && middle(range.left) < box.left) ++range.left;
    while (range.left < range.right && middle(range.right - 1) >= box.right) --range.right;
    for (int row = range.top; row < range.bottom; ++row) {
      if (middle(row) < box.top || middle(row) >= box.bottom) continue;
      const auto cells = mask.begin() + static_cast<std::ptrdiff_t>(depth.IndexOf(range.left, row));
      std::fill(cells, cells + (range.right - range.left), uint8_t{1});
    }
  }
  return mask;
}

BodyMemory RememberBody(const DepthCells& depth, const Box& box, const BodyPlane& body, const CellMask& before,
                        const CellMask& after) {
  BodyMemory memory{depth.RangeOf(box), {}, body};
  for (int row = memory.range.top; row < memory.range.bottom; ++row) {
    for (int column = memory.range.left; column < memory.range.right; ++column) {
      const size_t cell = depth.IndexOf(column, row);
      memory.cells.push_back(after[cell] == kBody && before[cell] != kBody ? kBody : uint8_t{0});
    }
  }
  return memory;
}

bool IsThereAgain(const BodySearch& search, const Box& box, const BodyMemory& memory) {
  constexpr float kLeastShare = 0.6f;
  const CellRange now = search.depth.RangeOf(box), &then = memory.range;
  const int dx = (now.left + now.right - then.left - then.right) / 2;
  const int dy = (now.top + now.bottom - then.top - then.bottom) / 2;
  float num_seen = 0, num_on = 0;
  auto is_body = memory.cells.begin();
  for (int row = then.top; row < then.bottom; ++row) {
    for (int column = then.left; column < then.right; ++column) {
      if (*is_body++ == 0) continue;
      const int x = column + dx, y = row + dy;
      if (x < 0 || x >= search.depth.columns() || y < 0 || y >= search.depth.rows()) continue;
      const float metres = search.depth.At(x, y);
      if (metres <= 0 || search.taken[search.depth.IndexOf(x, y)] != 0) continue;
      ++num_seen;
      num_on += memory.body.Holds(column, row, metres) ? 1.f : 0.f;
    }
  }
  return num_seen >= kLeastMeasured && num_on >= kLeastShare * num_seen;
}

Contrast ContrastOf(const BodySearch& search, const Box& box, const BodyPlane& body) {
  const double side = std::min(box.width(), box.height());
  const CellRange inner = search.depth.RangeOf(box);
  const CellRange grown = search.depth.RangeOf(box, kGrow * side);
  const CellRange outer = search.depth.RangeOf(box, (kGrow + kSurroundings) * side);
  Counts inside;
  std::array<Counts, 4> around;  // above, below, left, right
  for (int row = outer.top; row < outer.bottom; row += kStep) {
    for (int column = outer.left; column < outer.right; column += kStep) {
      const float metres = search.depth.At(column, row);
      if (metres <= 0) continue;
      if (inner.Holds(column, row)) {
        inside.Add(search.taken[search.depth.IndexOf(column, row)] == 0 && body.Holds(column, row, metres));
      } else if (!grown.Holds(column, row) && !search.IsInABox(column, row)) {
        const size_t where = row < grown.top ? 0 : row >= grown.bottom ? 1 : column < grown.left ? 2 : 3;
        around[where].Add(body.Holds(column, row, metres));
      }
    }
  }
  const auto contrast = [&] {
    Counts all;
    for (const Counts& counts : around) all.measured += counts.measured, all.on_body += counts.on_body;
    return inside.on_body / std::max(inside.measured, 1.f) -
           all.on_body / std::max(all.measured, kLeastAround * inside.measured + 1);
  };
  Contrast result;
  result.all_round = contrast();
  *std::max_element(around.begin(), around.end(),
                    [](const Counts& a, const Counts& b) { return a.on_body < b.on_body; }) = {};
  result.but_one_side = contrast();
  return result;
}

BodyPlane FitBody(const BodySearch& search, const Box& box, float metres) {
  const CellRange range = search.depth.RangeOf(box);
  constexpr int kTurns = 8;
  constexpr float kStiffness = 2e-4f;
  // A steeper plane goes from one body to the next, unless all of it is one body deep: who is near, or narrow.
  constexpr float kMostTurned = 0.9f;  // of its inverse depth over the picture's width, about 40 degrees
  constexpr float kBodyDeepM = 0.3f;
  const auto wide = static_cast<float>(std::max(range.right - range.left, 1));
  const float most_turned =
      std::max(kMostTurned / static_cast<float>(search.depth.columns()), kBodyDeepM / metres / wide);
  BodyPlane body{{{1 / metres, 0, 0}}, 0};
  for (int turn = 0; turn < kTurns; ++turn) {
    CellPlaneFit fit(range);
    for (int row = range.top; row < range.bottom; row += kStep) {
      for (int column = range.left; column < range.right; column += kStep) {
        const float depth = search.depth.At(column, row);
        if (search.taken[search.depth.IndexOf(column, row)] != 0 || !body.Holds(column, row, depth)) continue;
        const float across = fit.Across(column);
        fit.Add(column, row, depth, 1.2f - across * across);
      }
    }
    if (fit.weight() < 1) break;
    body.plane = fit.Solve(kStiffness, most_turned);
  }
  body.metres = body.plane.DepthAt((range.left + range.right) / 2, (range.top + range.bottom) / 2);
  return body;
}

CellMask WithBody(CellMask mask, const DepthCells& depth, const Box& box, const BodyPlane& body) {
  const CellRange range = depth.RangeOf(box);
  std::vector<std::pair<int, int>> edge;
  for (int row = range.top; row < range.bottom; ++row) {
    for (int column = range.left; column < range.right; ++column) {
      uint8_t& cell = mask[depth.IndexOf(column, row)];
      if (cell == kLying || !body.Holds(column, row, depth.At(column, row))) continue;
      cell = kBody;
      edge.emplace_back(column, row);
    }
  }
  const double margin = std::max(kGrow * std::min(box.width(), box.height()), 2.0 * kDepthCellPx);
  Spread(mask, depth, depth.RangeOf(box, margin), body, std::move(edge));
  const CellMask measured = mask;
  for (int row = range.top; row < range.bottom; ++row) {
    for (int column = range.left; column < range.right; ++column) {
      if (depth.At(column, row) <= 0 && MayBeBody(measured, depth, column, row)) {
        mask[depth.IndexOf(column, row)] = kBody;
      }
    }
  }
  return mask;
}

}  // namespace yorb

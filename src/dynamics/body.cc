// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace yorb {
namespace {

constexpr float kBinM = 0.05f;        // of the histogram of depths
constexpr int kBins = 240;            // up to 12 m, farther than such sensors see
constexpr int kWindowBins = 6;        // 0.3 m: a torso
constexpr float kFrontM = 0.25f;      // from the plane of a body to its arms
constexpr float kBackM = 0.15f;       // and to its back
constexpr double kGrow = 0.1;         // of the box, on each side
constexpr double kRing = 0.25;        // width of the surroundings, of the box's sides
constexpr float kLeastMeasured = 24;  // cells
constexpr float kMemory = 1.5f;       // how many times more being near the last depth is worth
constexpr float kSameM = 0.4f;        // how far a body may go from picture to picture

using Histogram = std::array<float, kBins>;

size_t BinOf(float metres) { return static_cast<size_t>(std::min(static_cast<int>(metres / kBinM), kBins - 1)); }

float DepthOf(int bin) { return (static_cast<float>(bin) + 0.5f) * kBinM; }

/// Depths in a box, those in the middle columns counting more.
Histogram Inside(const BodySearch& search, const CellRange& range) {
  Histogram counts{};
  const float middle = 0.5f * static_cast<float>(range.left + range.right - 1);
  const float half = 0.5f * static_cast<float>(range.right - range.left);
  for (int row = range.top; row < range.bottom; ++row) {
    for (int column = range.left; column < range.right; ++column) {
      const size_t cell = search.depth.IndexOf(column, row);
      const float metres = search.depth.At(column, row);
      const float off = (static_cast<float>(column) - middle) / half;
      if (metres > 0 && search.taken[cell] == 0) counts[BinOf(metres)] += 1.2f - off * off;
    }
  }
  return counts;
}

/// Measured cells of a box, those that are taken included.
float CountMeasured(const DepthCells& depth, const CellRange& range) {
  float count = 0;
  for (int row = range.top; row < range.bottom; ++row) {
    for (int column = range.left; column < range.right; ++column) count += depth.At(column, row) > 0 ? 1.f : 0.f;
  }
  return count;
}

/// Depths around a box that lie in no other box.
Histogram Around(const BodySearch& search, const Box& box) {
  const CellRange inner = search.depth.RangeOf(box);
  const CellRange outer = search.depth.RangeOf(box, kRing * std::min(box.width(), box.height()));
  Histogram counts{};
  for (int row = outer.top; row < outer.bottom; ++row) {
    for (int column = outer.left; column < outer.right; ++column) {
      if (row >= inner.top && row < inner.bottom && column == inner.left) column = inner.right;
      if (column >= outer.right) break;
      const float metres = search.depth.At(column, row);
      if (metres > 0 && !search.IsInABox(column, row)) counts[BinOf(metres)] += 1;
    }
  }
  return counts;
}

float Sum(const Histogram& counts, int begin, int end) {
  float sum = 0;
  for (int i = std::max(begin, 0); i < std::min(end, kBins); ++i) sum += counts[static_cast<size_t>(i)];
  return sum;
}

/// By how much a bin and its neighbours are denser in the box than around it, as shares.
Histogram Excess(const Histogram& inside, const Histogram& around, float num_inside) {
  const float num_around = std::max(Sum(around, 0, kBins), kLeastMeasured);
  Histogram excess{};
  for (int i = 0; i < kBins; ++i) {
    const int reach = DepthOf(i) > 2.5f ? 2 : 1;  // the noise of such sensors grows with the square of depth
    const auto width = static_cast<float>(2 * reach + 1);
    excess[static_cast<size_t>(i)] =
        (Sum(inside, i - reach, i + reach + 1) / num_inside - Sum(around, i - reach, i + reach + 1) / num_around) /
        width;
  }
  return excess;
}

/// Marks what hangs together with the cells of `edge` at the body's depth, within `range`.
void Spread(CellMask& mask, const DepthCells& depth, const CellRange& range, const BodyPlane& body,
            std::vector<std::pair<int, int>> edge) {
  constexpr std::pair<int, int> kSteps[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  while (!edge.empty()) {
    const auto [column, row] = edge.back();
    edge.pop_back();
    for (const auto& [dx, dy] : kSteps) {
      const int x = column + dx, y = row + dy;
      if (x < range.left || x >= range.right || y < range.top || y >= range.bottom) continue;
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

bool BodyPlane::Holds(int column, int row, float depth_m) const {
  const float off = depth_m - plane.DepthAt(column, row);
  const float noise = 0.01f * depth_m * depth_m;
  return depth_m > 0 && off > -(kFrontM + noise) && off < kBackM + noise;
}

bool BodySearch::IsInABox(int column, int row) const {
  const double x = (column + 0.5) * kDepthCellPx, y = (row + 0.5) * kDepthCellPx;
  return std::any_of(bodies.begin(), bodies.end(), [&](const Box& box) { return Holds(box, x, y); });
}

std::optional<BodySign> FindBody(const BodySearch& search, const Box& box, std::optional<float> last_metres) {
  if (search.depth.empty()) return std::nullopt;
  const CellRange range = search.depth.RangeOf(box);
  const Histogram inside = Inside(search, range), around = Around(search, box);
  const float num_measured = CountMeasured(search.depth, range);
  if (num_measured < kLeastMeasured) return std::nullopt;
  const Histogram excess = Excess(inside, around, num_measured);
  int best = 0;
  float best_score = -1e9f;
  for (int begin = 0; begin + kWindowBins <= kBins; ++begin) {
    const bool is_known = last_metres && std::abs(DepthOf(begin + kWindowBins / 2) - *last_metres) < kSameM;
    const float score = Sum(excess, begin, begin + kWindowBins) * (is_known ? kMemory : 1.f);
    if (score > best_score) best_score = score, best = begin;
  }
  const auto first = excess.begin() + best;
  const auto peak = std::max_element(first, first + kWindowBins);
  BodySign sign;
  sign.metres = DepthOf(static_cast<int>(peak - excess.begin()));
  sign.score = Sum(excess, best, best + kWindowBins);
  sign.num_cells = sign.score * num_measured;
  return sign;
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

bool HasSurroundings(const BodySearch& search, const Box& box) {
  return Sum(Around(search, box), 0, kBins) >= kLeastMeasured;
}

bool GoesOnAround(const BodySearch& search, const Box& box, const BodyPlane& body) {
  const Histogram around = Around(search, box);
  const int bin = static_cast<int>(BinOf(body.metres));
  const float near = Sum(around, bin - static_cast<int>(kBackM / kBinM), bin + static_cast<int>(kBackM / kBinM) + 1);
  const float all = Sum(around, 0, kBins);
  return all < kLeastMeasured || near > 0.5f * all;
}

std::optional<BodySign> FindAgain(const BodySearch& search, const Box& box, const BodyMemory& memory) {
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
  if (num_seen < kLeastMeasured || num_on < kLeastShare * num_seen) return std::nullopt;
  return BodySign{memory.body.metres, num_on / num_seen, num_on};
}

BodyPlane FitBody(const BodySearch& search, const Box& box, const BodySign& sign) {
  const CellRange range = search.depth.RangeOf(box);
  constexpr int kTurns = 8, kStep = 2;
  constexpr float kStiffness = 2e-4f;
  BodyPlane body{{{1 / sign.metres, 0, 0}}, 0};
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
    body.plane = fit.Solve(kStiffness);
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

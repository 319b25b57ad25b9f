// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/body_signs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace yorb {
namespace {

constexpr float kBinM = 0.05f;        // of the histogram of depths
constexpr int kBins = 240;            // up to 12 m, farther than such sensors see
constexpr int kWindowBins = 6;        // 0.3 m: a torso
constexpr int kWallBins = 3;          // 0.15 m: what so near a body's depth surrounds it is one thing with it
constexpr size_t kMostSigns = 3;      // in one box
constexpr float kLeastOther = 0.05f;  // share of the second sign and the third
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
  const CellRange outer = search.depth.RangeOf(box, kSurroundings * std::min(box.width(), box.height()));
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

}  // namespace

std::vector<BodySign> FindBodies(const BodySearch& search, const Box& box, std::optional<float> last_metres) {
  std::vector<BodySign> signs;
  if (search.depth.empty()) return signs;
  const CellRange range = search.depth.RangeOf(box);
  const float num_measured = CountMeasured(search.depth, range);
  if (num_measured < kLeastMeasured) return signs;
  Histogram excess = Excess(Inside(search, range), Around(search, box), num_measured);
  while (signs.size() < kMostSigns) {
    int best = 0;
    float best_score = -1e9f;
    for (int begin = 0; begin + kWindowBins <= kBins; ++begin) {
      const bool is_known = last_metres && std::abs(DepthOf(begin + kWindowBins / 2) - *last_metres) < kSameM;
      const float score = Sum(excess, begin, begin + kWindowBins) * (is_known ? kMemory : 1.f);
      if (score > best_score) best_score = score, best = begin;
    }
    const auto first = excess.begin() + best;
    const auto peak = std::max_element(first, first + kWindowBins);
    const float share = Sum(excess, best, best + kWindowBins);
    if (!signs.empty() && share < kLeastOther) break;
    signs.push_back({DepthOf(static_cast<int>(peak - excess.begin())), share * num_measured});
    std::fill(first, first + kWindowBins, 0.f);
  }
  return signs;
}

bool HasSurroundings(const BodySearch& search, const Box& box) {
  return Sum(Around(search, box), 0, kBins) >= kLeastMeasured;
}

bool GoesOnAround(const BodySearch& search, const Box& box, const BodyPlane& body) {
  const Histogram around = Around(search, box);
  const int bin = static_cast<int>(BinOf(body.metres));
  const float near = Sum(around, bin - kWallBins, bin + kWallBins + 1);
  const float all = Sum(around, 0, kBins);
  return all < kLeastMeasured || near > 0.5f * all;
}

}  // namespace yorb

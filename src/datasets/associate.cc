// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/associate.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/stats.h"

namespace yorb {
namespace {

constexpr double kSlower = 1.25;  // times the colour step: depth at 15 Hz beside 30 Hz is slower, jitter is not

struct Pair {
  int64_t distance_ns;
  int colour, depth;
};

std::vector<Pair> PairsWithin(const std::vector<Timestamp>& colour, const std::vector<Timestamp>& depth,
                              int64_t limit_ns) {
  std::vector<Pair> pairs;
  for (size_t i = 0; i < colour.size(); ++i) {
    auto near = std::lower_bound(depth.begin(), depth.end(), Timestamp{colour[i].ns - limit_ns});
    for (; near != depth.end() && near->ns <= colour[i].ns + limit_ns; ++near) {
      pairs.push_back({std::abs(near->ns - colour[i].ns), static_cast<int>(i), static_cast<int>(near - depth.begin())});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance_ns < b.distance_ns; });
  return pairs;
}

}  // namespace

std::vector<int> Associate(const std::vector<Timestamp>& colour, const std::vector<Timestamp>& depth,
                           double max_difference) {
  const auto pairs = PairsWithin(colour, depth, std::llround(max_difference * 1e9));
  std::vector<int> depth_of(colour.size(), -1);
  std::vector<bool> is_given(depth.size(), false);
  for (const Pair& pair : pairs) {
    if (depth_of[pair.colour] >= 0 || is_given[pair.depth]) continue;
    depth_of[pair.colour] = pair.depth;
    is_given[pair.depth] = true;
  }
  if (MedianStep(depth) <= kSlower * MedianStep(colour)) return depth_of;
  for (const Pair& pair : pairs) {
    if (depth_of[pair.colour] < 0) depth_of[pair.colour] = pair.depth;
  }
  return depth_of;
}

}  // namespace yorb

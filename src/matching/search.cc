// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace yorb {

void DropOddTurns(const std::vector<float>& turn_rad, Claims& claims) {
  constexpr int kBins = 30, kKept = 3;
  constexpr float kMinShare = 0.1f;  // of the fullest bin
  constexpr float kTwoPi = 6.2831853f;
  const auto bin_of = [&](size_t index) {
    const float turn = turn_rad[index] - kTwoPi * std::floor(turn_rad[index] / kTwoPi);
    return static_cast<int>(std::lround(turn / kTwoPi * kBins)) % kBins;
  };

  std::array<int, kBins> counts{};
  const std::vector<int>& owners = claims.owners();
  for (size_t i = 0; i < owners.size(); ++i) {
    if (owners[i] >= 0) ++counts[static_cast<size_t>(bin_of(i))];
  }
  std::array<int, kBins> order{};
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return counts[static_cast<size_t>(a)] > counts[static_cast<size_t>(b)]; });
  std::array<bool, kBins> is_kept{};
  const float least = kMinShare * static_cast<float>(counts[static_cast<size_t>(order[0])]);
  for (size_t rank = 0; rank < kKept; ++rank) {
    const auto bin = static_cast<size_t>(order[rank]);
    is_kept[bin] = static_cast<float>(counts[bin]) >= least;
  }
  for (size_t i = 0; i < owners.size(); ++i) {
    if (owners[i] >= 0 && !is_kept[static_cast<size_t>(bin_of(i))]) claims.Drop(i);
  }
}

}  // namespace yorb

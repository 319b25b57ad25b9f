// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/associate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <tuple>

#include "core/random.h"
#include "evaluation/test_trajectories.h"

namespace yorb {
namespace {

/// TUM's associate.py as it stands there: all pairs, sorted, taken greedily.
std::vector<StampPair> SlowTwin(const std::vector<Timestamp>& first, const std::vector<Timestamp>& second,
                                double max_difference, double offset) {
  std::vector<std::tuple<double, double, double, size_t, size_t>> all;
  for (size_t i = 0; i < first.size(); ++i) {
    for (size_t j = 0; j < second.size(); ++j) {
      const double a = TumSeconds(first[i]), b = TumSeconds(second[j]);
      if (std::abs(a - (b + offset)) < max_difference) all.emplace_back(std::abs(a - (b + offset)), a, b, i, j);
    }
  }
  std::sort(all.begin(), all.end());
  std::set<size_t> used_first, used_second;
  std::vector<StampPair> pairs;
  for (const auto& [difference, a, b, i, j] : all) {
    if (used_first.count(i) + used_second.count(j) > 0) continue;
    used_first.insert(i);
    used_second.insert(j);
    pairs.push_back({i, j});
  }
  std::sort(pairs.begin(), pairs.end(), [](const StampPair& a, const StampPair& b) { return a.first < b.first; });
  return pairs;
}

std::vector<Timestamp> RandomStamps(Random& random, size_t count, int64_t span_ms) {
  std::set<int64_t> chosen;
  while (chosen.size() < count) chosen.insert(random.Below(static_cast<uint32_t>(span_ms)));
  std::vector<Timestamp> stamps;
  for (const int64_t ms : chosen) stamps.push_back(AtMs(ms));
  return stamps;
}

TEST(Associate, EqualsTheSlowTwinTiesIncluded) {
  Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    // Whole milliseconds in a short span: many ties and many rivals.
    const auto first = RandomStamps(random, 1 + random.Below(40), 200),
               second = RandomStamps(random, 1 + random.Below(40), 200);
    const double max_difference = 1e-3 * (1 + random.Below(trial % 2 == 0 ? 10 : 1000)),
                 offset = 1e-3 * random.Below(30) - 0.015;
    const auto pairs = AssociateStamps(first, second, max_difference, offset);
    ASSERT_EQ(pairs, SlowTwin(first, second, max_difference, offset)) << "trial " << trial;
  }
}

TEST(Associate, EachStampIsUsedOnceAndTheNearestWins) {
  const std::vector<Timestamp> truth = {AtMs(0), AtMs(100)}, pictures = {AtMs(-20), AtMs(7), AtMs(12), AtMs(95)};
  const std::vector<StampPair> expected = {{0, 1}, {1, 3}};
  EXPECT_EQ(AssociateStamps(truth, pictures, 0.05), expected);
}

TEST(Associate, TheLimitItselfIsTooFar) {
  const std::vector<Timestamp> a = {Timestamp{0}}, b = {Timestamp{250000000}};  // exact in binary
  EXPECT_TRUE(AssociateStamps(a, b, 0.25).empty());
  EXPECT_EQ(AssociateStamps(a, b, 0.2500001).size(), 1u);
  EXPECT_EQ(AssociateStamps(a, b, 1e-9, -0.25).size(), 1u);
  EXPECT_TRUE(AssociateStamps(a, {}, 1).empty());
  EXPECT_TRUE(AssociateStamps(a, b, 0).empty());
}

TEST(Associate, ManyStampsAndAWideLimitTakeNoTime) {
  constexpr size_t kCount = 200000;
  std::vector<Timestamp> first, second;
  for (size_t i = 0; i < kCount; ++i) {
    first.push_back(AtMs(static_cast<int64_t>(10 * i)));
    second.push_back(AtMs(static_cast<int64_t>(10 * i + 3)));
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(AssociateStamps(first, second, 1e6).size(), kCount);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));  // all pairs would take hours
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace yorb {
namespace {

TEST(Random, GivesTheSameNumbersForEver) {
  // Results of runs are repeated to the bit from a seed: these numbers may never change.
  Random random(1);
  EXPECT_EQ(random.Next(), 10443683933123270011u);
  EXPECT_EQ(random.Next(), 11546425182604795145u);
  EXPECT_EQ(Random(1, 5).Next(), 604587959304212404u);
  EXPECT_EQ(Random(0).Next(), 13810761654074628661u);
}

TEST(Random, SeedsAndStreamsDiffer) {
  std::set<uint64_t> first;
  for (uint64_t seed = 0; seed < 100; ++seed) {
    for (uint64_t stream = 0; stream < 100; ++stream) first.insert(Random(seed, stream).Next());
  }
  EXPECT_EQ(first.size(), 10000u);
}

TEST(Random, BelowReachesEveryNumberAboutEquallyOften) {
  Random random(2);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) {
    const uint32_t number = random.Below(7);
    ASSERT_LT(number, 7u);
    ++counts[number];
  }
  for (const int count : counts) EXPECT_NEAR(count, 10000, 500);  // over five standard deviations
  EXPECT_EQ(random.Below(1), 0u);
  EXPECT_LT(random.Below(0xffffffffu), 0xffffffffu);
}

TEST(Random, UniformFillsItsRange) {
  Random random(3);
  double low = 1, high = 0, sum = 0;
  for (int i = 0; i < 100000; ++i) {
    const double u = random.Uniform();
    low = std::min(low, u);
    high = std::max(high, u);
    sum += u;
  }
  EXPECT_GE(low, 0);
  EXPECT_LT(low, 0.001);
  EXPECT_LT(high, 1);
  EXPECT_GT(high, 0.999);
  EXPECT_NEAR(sum / 100000, 0.5, 0.005);
  for (int i = 0; i < 1000; ++i) {
    const double v = random.Uniform(-2, 5);
    ASSERT_TRUE(v >= -2 && v < 5);
  }
}

TEST(Random, GaussianHasItsMoments) {
  Random random(4);
  constexpr int kCount = 200000;
  double sum = 0, squares = 0, fourth = 0;
  int beyond_two = 0;
  for (int i = 0; i < kCount; ++i) {
    const double g = random.Gaussian();
    ASSERT_TRUE(std::isfinite(g));
    sum += g;
    squares += g * g;
    fourth += g * g * g * g;
    beyond_two += std::abs(g) > 2;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.012);
  EXPECT_NEAR(squares / kCount, 1, 0.017);
  EXPECT_NEAR(fourth / kCount, 3, 0.12);
  EXPECT_NEAR(beyond_two / static_cast<double>(kCount), 0.0455, 0.0025);
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/stats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace yorb {
namespace {

TEST(Stats, AgreeWithValuesWorkedOutByHand) {
  const Summary s = Summarize({3, 1, 4, 1, 5, 9, 2, 6});
  EXPECT_EQ(s.count, 8u);
  EXPECT_DOUBLE_EQ(s.mean, 31.0 / 8);
  EXPECT_DOUBLE_EQ(s.rmse, std::sqrt(173.0 / 8));
  EXPECT_DOUBLE_EQ(s.std, std::sqrt(173.0 / 8 - 31.0 * 31.0 / 64));
  EXPECT_DOUBLE_EQ(s.median, 3.5);
  EXPECT_EQ(s.min, 1);
  EXPECT_EQ(s.max, 9);
}

TEST(Stats, OfNothingAreZeroAndOfOneTheValue) {
  const Summary none = Summarize({});
  EXPECT_EQ(none.count, 0u);
  EXPECT_EQ(none.rmse, 0);
  const Summary one = Summarize({-2});
  EXPECT_EQ(one.mean, -2);
  EXPECT_EQ(one.median, -2);
  EXPECT_EQ(one.rmse, 2);
  EXPECT_EQ(one.std, 0);
}

TEST(Stats, SpreadDoesNotSufferFromALargeMean) {
  // The textbook's sum of squares minus the squared mean gives 0 here.
  EXPECT_NEAR(Summarize({1e9 + 0.1, 1e9 + 0.2, 1e9 + 0.3}).std, std::sqrt(2.0 / 3) * 0.1, 1e-7);
}

TEST(Stats, RmseIsOfMeanAndSpread) {
  Random random(11);
  std::vector<double> values(1000);
  for (double& v : values) v = random.Uniform(-3, 7);
  const Summary s = Summarize(values);
  EXPECT_NEAR(s.rmse * s.rmse, s.mean * s.mean + s.std * s.std, 1e-9);
}

TEST(Stats, QuantilesLieBetweenNeighboursAsNumpyHasIt) {
  const std::vector<double> values = {15, 20, 35, 40, 50};
  EXPECT_DOUBLE_EQ(Quantile(values, 0.4), 29);
  EXPECT_DOUBLE_EQ(Quantile(values, 0.95), 48);
  EXPECT_EQ(Quantile(values, 0), 15);
  EXPECT_EQ(Quantile(values, 1), 50);
  EXPECT_EQ(Quantile(values, 2), 50);
  EXPECT_EQ(Quantile(values, -1), 15);
  EXPECT_EQ(Quantile({}, 0.5), 0);
  EXPECT_EQ(Quantile({7}, 0.3), 7);
}

TEST(Stats, QuantileAgreesWithSorting) {
  Random random(12);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> values(1 + random.Below(40));
    for (double& v : values) v = static_cast<double>(random.Below(10));  // many equal ones
    const double fraction = random.Uniform();
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double position = fraction * static_cast<double>(sorted.size() - 1);
    const auto low = static_cast<size_t>(position);
    const size_t high = std::min(low + 1, sorted.size() - 1);
    const double expected = sorted[low] + (sorted[high] - sorted[low]) * (position - static_cast<double>(low));
    ASSERT_DOUBLE_EQ(Quantile(values, fraction), expected);
  }
}

TEST(MedianStep, IsThatOfNeighboursAndZeroForFew) {
  EXPECT_EQ(MedianStep({}), 0);
  EXPECT_EQ(MedianStep({{5}}), 0);
  EXPECT_NEAR(MedianStep({{0}, {100000000}, {200000000}, {900000000}}), 0.1, 1e-12);
}

}  // namespace
}  // namespace yorb

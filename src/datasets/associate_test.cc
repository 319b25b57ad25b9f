// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/associate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "core/stats.h"

namespace yorb {
namespace {

std::vector<Timestamp> Every(double step_s, int count, double start_s = 0) {
  std::vector<Timestamp> times;
  for (int i = 0; i < count; ++i) times.push_back({std::llround((start_s + i * step_s) * 1e9)});
  return times;
}

/// The slow twin: takes the nearest free pair again and again. Ties go to the earlier colour, then the earlier depth.
std::vector<int> AssociateSlowly(const std::vector<Timestamp>& colour, const std::vector<Timestamp>& depth) {
  std::vector<int> depth_of(colour.size(), -1);
  std::vector<bool> is_given(depth.size(), false);
  while (true) {
    int64_t best = 20000001;
    size_t best_i = 0, best_j = 0;
    for (size_t i = 0; i < colour.size(); ++i) {
      for (size_t j = 0; j < depth.size(); ++j) {
        const int64_t apart = std::abs(colour[i].ns - depth[j].ns);
        if (depth_of[i] < 0 && !is_given[j] && apart < best) best = apart, best_i = i, best_j = j;
      }
    }
    if (best > 20000000) return depth_of;
    depth_of[best_i] = static_cast<int>(best_j);
    is_given[best_j] = true;
  }
}

TEST(Associate, EqualsItsSlowTwin) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int64_t> jitter_ns(-15000000, 15000000);
  for (int round = 0; round < 20; ++round) {
    auto colour = Every(0.033, 60), depth = Every(0.033, 60, 0.008);
    for (auto* list : {&colour, &depth}) {
      for (Timestamp& time : *list) time.ns += jitter_ns(random);
      std::sort(list->begin(), list->end());
    }
    ASSERT_LE(MedianStep(depth), 1.25 * MedianStep(colour)) << "the twin knows no sharing";
    EXPECT_EQ(Associate(colour, depth), AssociateSlowly(colour, depth));
  }
}

TEST(Associate, TheLimitIsTwentyMilliseconds) {
  EXPECT_EQ(Associate(Every(1, 3), Every(1, 3, 0.020)), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(Associate(Every(1, 3), Every(1, 3, 0.020001)), (std::vector<int>{-1, -1, -1}));
}

TEST(Associate, ADroppedDepthPictureIsNotReplacedByItsNeighbour) {
  // 100 Hz: the neighbours' depth is within 20 ms, and belongs to other moments all the same.
  const auto colour = Every(0.01, 7);
  auto depth = Every(0.01, 7);
  depth.erase(depth.begin() + 3);
  EXPECT_EQ(Associate(colour, depth), (std::vector<int>{0, 1, 2, -1, 3, 4, 5}));
}

TEST(Associate, SlowerDepthServesTwoColourPictures) {
  const auto colour = Every(1 / 60.0, 8), depth = Every(1 / 30.0, 4);
  const auto depth_of = Associate(colour, depth);
  std::vector<int> uses(depth.size());
  for (size_t i = 0; i < colour.size(); ++i) {
    ASSERT_GE(depth_of[i], 0) << i;
    ++uses[depth_of[i]];
    EXPECT_LE(std::abs(SecondsBetween(colour[i], depth[depth_of[i]])), kMaxPairDifference);
  }
  for (size_t i = 0; i < colour.size(); i += 2) EXPECT_EQ(depth_of[i], static_cast<int>(i / 2));
}

TEST(Associate, EmptyListsAndSinglePicturesAreFine) {
  EXPECT_TRUE(Associate({}, Every(1, 3)).empty());
  EXPECT_EQ(Associate(Every(1, 2), {}), (std::vector<int>{-1, -1}));
  EXPECT_EQ(Associate(Every(1, 1), Every(1, 1, 0.01)), (std::vector<int>{0}));
}

}  // namespace
}  // namespace yorb

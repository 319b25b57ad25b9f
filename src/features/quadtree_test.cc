// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/quadtree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/random.h"

namespace yorb {
namespace {

constexpr CornerArea kArea{19, 19, 621, 461};

/// Distinct pixels; most of them crowd in one corner of the area.
std::vector<Corner> CrowdedCorners(size_t count, uint64_t seed) {
  Random random(seed);
  std::set<std::pair<int, int>> taken;
  while (taken.size() < count) {
    const bool is_crowded = random.Below(10) < 7;
    const int x = kArea.left + static_cast<int>(random.Below(is_crowded ? 150 : 602));
    const int y = kArea.top + static_cast<int>(random.Below(is_crowded ? 110 : 442));
    taken.insert({y, x});
  }
  std::vector<Corner> corners;
  for (const auto& [y, x] : taken) {
    const int score = 7 + static_cast<int>(random.Below(60));
    corners.push_back({x, y, score, static_cast<float>(score), 0.f, 0.f});
  }
  return corners;
}

/// Equation (5) over 3 x 3 fields.
double Dispersion(const std::vector<Corner>& corners) {
  double counts[9] = {}, sum = 0;
  for (const Corner& c : corners) counts[(c.y - 19) * 3 / 442 * 3 + (c.x - 19) * 3 / 602] += 1;
  const double mean = static_cast<double>(corners.size()) / 9;
  for (const double count : counts) sum += (count - mean) * (count - mean);
  return std::sqrt(sum / 9);
}

bool IsSubset(const std::vector<Corner>& some, const std::vector<Corner>& all) {
  std::set<std::pair<int, int>> places;
  for (const Corner& c : all) places.insert({c.x, c.y});
  std::set<std::pair<int, int>> once;
  return std::all_of(some.begin(), some.end(), [&](const Corner& c) {
    return places.count({c.x, c.y}) == 1 && once.insert({c.x, c.y}).second;
  });
}

using Keep = const std::vector<Corner>& (Quadtree::*)(const std::vector<Corner>&, const CornerArea&, int);
class QuadtreeTest : public testing::TestWithParam<Keep> {};

TEST_P(QuadtreeTest, GivesWhatIsWanted) {
  Quadtree quadtree;
  for (const size_t count : {size_t{500}, size_t{3000}, size_t{8000}}) {
    const std::vector<Corner> corners = CrowdedCorners(count, count);
    for (const int wanted : {60, 217, 499}) {
      const std::vector<Corner>& kept = (quadtree.*GetParam())(corners, kArea, wanted);
      EXPECT_EQ(kept.size(), static_cast<size_t>(wanted));
      EXPECT_TRUE(IsSubset(kept, corners));
    }
  }
}

TEST_P(QuadtreeTest, SpreadsMoreEvenlyThanTheStrongest) {
  Quadtree quadtree;
  const std::vector<Corner> corners = CrowdedCorners(3000, 9);
  std::vector<Corner> strongest = corners;
  std::sort(strongest.begin(), strongest.end(), [](const Corner& a, const Corner& b) { return a.score > b.score; });
  strongest.resize(217);
  EXPECT_LT(Dispersion((quadtree.*GetParam())(corners, kArea, 217)), Dispersion(strongest));
}

TEST_P(QuadtreeTest, KeepsAllWhenThereAreFewer) {
  Quadtree quadtree;
  const std::vector<Corner> corners = CrowdedCorners(100, 1);
  EXPECT_EQ((quadtree.*GetParam())(corners, kArea, 100).size(), 100u);
  EXPECT_EQ((quadtree.*GetParam())(corners, kArea, 1000).size(), 100u);
  EXPECT_TRUE((quadtree.*GetParam())(corners, kArea, 0).empty());
  EXPECT_TRUE((quadtree.*GetParam())({}, kArea, 100).empty());
}

TEST_P(QuadtreeTest, EndsWhereCornersCannotBeToldApart) {
  Quadtree quadtree;
  const std::vector<Corner> corners(50, Corner{100, 100, 20, 20.f, 0.f, 0.f});
  EXPECT_LE((quadtree.*GetParam())(corners, kArea, 30).size(), 30u);
}

TEST_P(QuadtreeTest, ResultDoesNotDependOnWhatCameBefore) {
  Quadtree used, fresh;
  (used.*GetParam())(CrowdedCorners(5000, 2), kArea, 300);
  const std::vector<Corner> corners = CrowdedCorners(1000, 3);
  const std::vector<Corner>& a = (used.*GetParam())(corners, kArea, 200);
  const std::vector<Corner>& b = (fresh.*GetParam())(corners, kArea, 200);
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(a[i].x == b[i].x && a[i].y == b[i].y);
}

INSTANTIATE_TEST_SUITE_P(BothWays, QuadtreeTest,
                         testing::Values(&Quadtree::KeepBestOfEach, &Quadtree::KeepSinglesAndBest));

TEST(Quadtree, ImprovedKeepsStrongPointsThatShareANode) {
  // Two strong neighbours among many weak points: one node of the original has room for one of them only.
  std::vector<Corner> corners = CrowdedCorners(2000, 4);
  for (Corner& c : corners) c.response = static_cast<float>(c.score % 20);
  corners.push_back({400, 300, 200, 200.f, 0.f, 0.f});
  corners.push_back({402, 300, 190, 190.f, 0.f, 0.f});
  const auto count_strong = [](const std::vector<Corner>& kept) {
    return std::count_if(kept.begin(), kept.end(), [](const Corner& c) { return c.response > 100; });
  };
  Quadtree quadtree;
  EXPECT_EQ(count_strong(quadtree.KeepBestOfEach(corners, kArea, 100)), 1);
  EXPECT_EQ(count_strong(quadtree.KeepSinglesAndBest(corners, kArea, 100)), 2);
}

}  // namespace
}  // namespace yorb

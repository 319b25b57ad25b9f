// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/random.h"

namespace yorb {
namespace {

constexpr PixelBounds kBounds{-12.5f, 655.f, -9.f, 490.f};

std::vector<Eigen::Vector2f> RandomPoints(size_t count, uint64_t seed) {
  Random random(seed);
  std::vector<Eigen::Vector2f> points(count);
  for (Eigen::Vector2f& p : points) {  // some fall outside of the bounds
    p = {static_cast<float>(random.Uniform(-30, 680)), static_cast<float>(random.Uniform(-30, 510))};
  }
  return points;
}

std::vector<uint32_t> Near(const Grid& grid, float x, float y, float radius) {
  std::vector<uint32_t> found;
  grid.VisitNear(x, y, radius, [&](uint32_t index) { found.push_back(index); });
  return found;
}

TEST(Grid, FindsEveryPointOfTheSquareOnce) {
  const std::vector<Eigen::Vector2f> points = RandomPoints(2000, 1);
  const Grid grid(kBounds, points);
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const float x = static_cast<float>(random.Uniform(-50, 700)), y = static_cast<float>(random.Uniform(-50, 520));
    const float radius = static_cast<float>(random.Uniform(0, 60));
    std::vector<uint32_t> found = Near(grid, x, y, radius);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (uint32_t k = 0; k < points.size(); ++k) {
      if (!kBounds.Contains(points[k].x(), points[k].y())) continue;
      const bool is_inside = std::abs(points[k].x() - x) <= radius && std::abs(points[k].y() - y) <= radius;
      EXPECT_TRUE(!is_inside || std::binary_search(found.begin(), found.end(), k));
    }
  }
}

TEST(Grid, VisitsFewPointsBesidesThoseNear) {
  const Grid grid(kBounds, RandomPoints(2000, 3));
  EXPECT_LT(Near(grid, 300, 200, 10).size(), 30u);
  EXPECT_EQ(Near(grid, 300, 200, 10000).size(), 2000u);
}

TEST(Grid, OddQuestionsAreAnswered) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  const Grid grid(kBounds, RandomPoints(100, 4));
  Near(grid, nan, nan, nan);
  Near(grid, -infinite, 1e30f, 5);
  EXPECT_EQ(Near(grid, 300, 200, infinite).size(), 100u);
  EXPECT_TRUE(Near(Grid(), 0, 0, 100).empty());
  EXPECT_TRUE(Near(Grid(kBounds, {}), 0, 0, 100).empty());
}

}  // namespace
}  // namespace yorb

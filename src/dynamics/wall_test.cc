// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/wall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/random.h"
#include "dynamics/test_depth.h"

namespace yorb {
namespace {

const Box kPoster{"person", 0.9, 240, 120, 400, 380};

/// A depth picture of `metres` at each pixel, with a sensor's noise and holes.
DepthImage Measured(const std::function<double(int x, int y)>& metres) {
  DepthImage depth{cv::Mat(kHeight, kWidth, CV_32FC1), 1};
  Random random(11, 2);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double truth = metres(x, y), noise = 0.004 * truth * truth * (random.Uniform() - 0.5);
      depth.pixels.at<float>(y, x) = random.Uniform() < 0.2 ? 0.f : static_cast<float>(truth + noise);
    }
  }
  return depth;
}

/// A wall that slants away to the right.
double Wall(int x, int) { return 1 / (0.45 - 0.0002 * x); }

bool IsWall(const DepthImage& image, const Box& box, const std::vector<Box>& bodies = {}) {
  const DepthCells depth(image);
  const CellMask taken(static_cast<size_t>(depth.columns() * depth.rows()), 0);
  return LiesInAWall({depth, taken, CellsInBoxes(depth, bodies)}, box);
}

TEST(LiesInAWall, APosterDoes) {
  EXPECT_TRUE(IsWall(Measured(Wall), kPoster));
  EXPECT_TRUE(IsWall(Measured(Wall), {"person", 0.9, 0, 120, 160, 380})) << "at the left edge of the picture";
  EXPECT_TRUE(IsWall(Measured(Wall), {"person", 0.9, 300, 0, kWidth, kHeight})) << "only the left of it is in view";
}

TEST(LiesInAWall, TwoPeopleOfOnePosterDo) {
  const Box other{"person", 0.8, 380, 100, kWidth, 470};
  EXPECT_TRUE(IsWall(Measured(Wall), kPoster, {kPoster, other}));
  EXPECT_TRUE(IsWall(Measured(Wall), other, {kPoster, other})) << "all beside it lies in the first one's box";
}

TEST(LiesInAWall, WhoStandsOrLeansBeforeItDoesNot) {
  for (const double off : {1.2, 0.25}) {
    const auto image = Measured([&](int x, int y) {
      const double across = (x - 320) / 75.0, along = (y - 250) / 125.0;
      const double round = 1 - across * across - along * along;
      return Wall(x, y) - (round > 0 ? off * std::sqrt(round) : 0);
    });
    EXPECT_FALSE(IsWall(image, kPoster)) << off << " m before the wall";
  }
}

TEST(LiesInAWall, WhoFillsADoorDoesNot) {
  const auto door =
      Measured([](int x, int y) { return x > 244 && x < 396 && y > 124 ? Wall(x, y) + 0.4 : Wall(x, y); });
  EXPECT_FALSE(IsWall(door, kPoster));
}

TEST(LiesInAWall, WhoFillsABoxDoesNot) {
  // As flat as a board, and cut by three edges of the picture or by the lower edge of the box.
  const auto before = [](int left, int top, int right) {
    return Measured([=](int x, int y) { return x > left && x < right && y > top ? 1.5 : Wall(x, y); });
  };
  EXPECT_FALSE(IsWall(before(300, -1, kWidth), {"person", 0.9, 300, 0, kWidth, kHeight}));
  EXPECT_FALSE(IsWall(before(240, 120, 400), kPoster));
}

TEST(LiesInAWall, WhereTheWallEndsNothingIsSaid) {
  const auto image = Measured([](int x, int y) { return x < 400 ? Wall(x, y) : 4.5; });
  EXPECT_FALSE(IsWall(image, kPoster)) << "a flat body that its box cuts on the left would look like that";
}

TEST(LiesInAWall, IsNotSaidWithoutSurroundingsOrFarAway) {
  EXPECT_FALSE(IsWall(Measured(Wall), {"person", 0.9, 0, 0, kWidth, kHeight}));
  const auto gap = Measured([](int x, int y) { return x > 224 && x < 416 && y > 104 && y < 396 ? Wall(x, y) : 1.0; });
  EXPECT_FALSE(IsWall(gap, kPoster, {{"person", 0.9, 0, 0, kWidth, kHeight}})) << "another body is all around";
  EXPECT_FALSE(IsWall(Measured([](int, int) { return 7; }), kPoster));
  EXPECT_FALSE(IsWall(Measured([](int, int) { return 0; }), kPoster));
}

}  // namespace
}  // namespace yorb

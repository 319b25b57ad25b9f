// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// A camera that looks down by 30 degrees, 0.6 m above a desk, with a wall behind and a cylinder that stands on it.
#include "dynamics/lying_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "dynamics/test_depth.h"

namespace yorb {
namespace {

constexpr double kFocal = 520, kPitch = 0.52, kAboveM = 0.6, kWallM = 1.8;

enum class Part { kDesk, kWall, kColumn };

struct Seen {
  double metres;
  Part part;
};

/// What one pixel sees. The column is a board that stands upright at 1 m, with round sides.
Seen Look(int x, int y) {
  const double across = (x - kWidth / 2.0) / kFocal, down = (y - kHeight / 2.0) / kFocal;
  const double fall = std::sin(kPitch) + down * std::cos(kPitch);     // of the ray, a metre of depth
  const double forward = std::cos(kPitch) - down * std::sin(kPitch);  // the same along the desk
  const double board = 1.0 / forward;
  const double off = std::abs(across * board) / 0.15;
  if (off < 1 && fall * board < kAboveM) return {board - 0.1 * std::sqrt(1 - off * off), Part::kColumn};
  const double wall = kWallM / forward, desk = fall > 0 ? kAboveM / fall : 1e9;
  return desk < wall ? Seen{desk, Part::kDesk} : Seen{wall, Part::kWall};
}

TEST(LyingCells, TellsADeskFromWhatStands) {
  Random random(3, 1);
  DepthImage depth{cv::Mat(kHeight, kWidth, CV_16UC1), kMetresPerUnit};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double metres = Look(x, y).metres;
      const double noise = 0.003 * metres * metres * (random.Uniform() - 0.5);
      const bool is_hole = random.Uniform() < 0.03;
      depth.pixels.at<uint16_t>(y, x) =
          is_hole ? uint16_t{0} : static_cast<uint16_t>((metres + noise) / kMetresPerUnit);
    }
  }
  const DepthCells cells(depth);
  const CellMask lying = MarkLying(cells);
  double num[3] = {}, marked[3] = {};
  for (int row = 0; row < cells.rows(); ++row) {
    for (int column = 0; column < cells.columns(); ++column) {
      const auto part = static_cast<size_t>(Look(column * kDepthCellPx + 1, row * kDepthCellPx + 1).part);
      ++num[part], marked[part] += lying[cells.IndexOf(column, row)] == kLying;
    }
  }
  EXPECT_GT(marked[0] / num[0], 0.7) << "the desk, but for where it is seen from straight above";
  EXPECT_LT(marked[1] / num[1], 0.02) << "the wall";
  EXPECT_LT(marked[2] / num[2], 0.02) << "the column";
}

TEST(LyingCells, ABellyIsNoDesk) {
  // Somebody who stands half a metre away and leans back: a hand's breadth of the trunk comes nearer further down.
  DepthImage depth{cv::Mat(kHeight, kWidth, CV_16UC1), kMetresPerUnit};
  for (int y = 0; y < kHeight; ++y) {
    const double metres = 0.5 - 0.12 * std::clamp((y - 180) / 100.0, 0.0, 1.0);
    for (int x = 0; x < kWidth; ++x) {
      const bool is_body = x > 250 && x < 390;
      depth.pixels.at<uint16_t>(y, x) = static_cast<uint16_t>((is_body ? metres : kWallM) / kMetresPerUnit);
    }
  }
  const CellMask lying = MarkLying(DepthCells(depth));
  EXPECT_EQ(std::count(lying.begin(), lying.end(), kLying), 0);
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/cell_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace yorb {
namespace {

/// A slanting wall, about two metres away.
float Metres(int column, int row) {
  return 1 / (0.4f + 0.0008f * static_cast<float>(column) - 0.0005f * static_cast<float>(row));
}

TEST(CellPlaneFit, FindsThePlaneOfASmallRangeFarFromTheOrigin) {
  const CellRange range{150, 110, 156, 118};
  CellPlaneFit fit(range);
  for (int row = range.top; row < range.bottom; ++row) {
    for (int column = range.left; column < range.right; ++column) fit.Add(column, row, Metres(column, row));
  }
  const CellPlane plane = fit.Solve(0);
  EXPECT_NEAR(plane.inverse_depth[1], 0.0008, 1e-5);
  EXPECT_NEAR(plane.inverse_depth[2], -0.0005, 1e-5);
  for (const auto& [column, row] : {std::pair(150, 110), std::pair(155, 117), std::pair(140, 100)}) {
    EXPECT_NEAR(plane.DepthAt(column, row), Metres(column, row), 1e-3);
  }
}

TEST(CellPlaneFit, WeightsDecide) {
  const CellRange range{0, 0, 4, 4};
  CellPlaneFit fit(range);
  for (int column = 0; column < 4; ++column) {
    fit.Add(column, 0, 2, 1000);
    fit.Add(column, 3, 2, 1000);
    fit.Add(column, 1, 4, 1e-3f);
  }
  EXPECT_NEAR(fit.Solve(0).DepthAt(2, 2), 2, 1e-3);
}

TEST(CellPlaneFit, OneRowAloneSaysNothingOfHowItLeans) {
  const CellRange range{10, 20, 18, 40};
  CellPlaneFit fit(range);
  for (int column = range.left; column < range.right; ++column) fit.Add(column, 20, 2);
  const CellPlane plane = fit.Solve(1e-3f);
  EXPECT_NEAR(plane.DepthAt(14, 20), 2, 0.01);
  EXPECT_LT(std::abs(plane.inverse_depth[2]), 1e-2) << "held upright";
  EXPECT_EQ(fit.weight(), 8);
}

TEST(CellPlaneFit, ASteepPlaneIsTurnedNoFurtherThanAllowed) {
  const CellRange range{40, 20, 60, 50};
  CellPlaneFit fit(range);
  for (int row = range.top; row < range.bottom; ++row) {
    for (int column = range.left; column < range.right; ++column) {
      const float across = static_cast<float>(column) - 49.5f, along = static_cast<float>(row) - 34.5f;
      fit.Add(column, row, 1 / (0.5f + 0.01f * across + 0.002f * along));
    }
  }
  const CellPlane free = fit.Solve(0, 0.03f), held = fit.Solve(0, 0.01f);
  EXPECT_NEAR(free.inverse_depth[1], 0.01, 1e-4) << "less than the limit";
  EXPECT_NEAR(held.inverse_depth[1], 0.005, 1e-4);
  EXPECT_NEAR(held.inverse_depth[2], 0.002, 1e-4) << "the other way it leans as it did";
  EXPECT_NEAR(held.InverseDepthAt(50, 35), 0.5 + 0.0025 + 0.001, 1e-3);
}

}  // namespace
}  // namespace yorb

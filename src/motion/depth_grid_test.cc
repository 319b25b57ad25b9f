// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/depth_grid.h"

#include <gtest/gtest.h>

#include "motion/past_views.h"
#include "motion/test_scene.h"

namespace yorb {
namespace {

DepthImage Depth(const Rig& rig, float metres) {
  return {cv::Mat(rig.camera.height, rig.camera.width, CV_32FC1, cv::Scalar(static_cast<double>(metres))), 1};
}

size_t Cell(const DepthGrid& grid, float x_px, float y_px) { return static_cast<size_t>(grid.CellAt(x_px, y_px)); }

TEST(DepthGrid, IsEmptyWithoutADepthPicture) {
  const DepthGridMaker maker(DepthTestRig());
  EXPECT_TRUE(maker.Make({}).empty());
  EXPECT_TRUE(maker.Make({cv::Mat::ones(10, 10, CV_32FC1), 1}).empty());
}

TEST(DepthGrid, HasASurfaceButNotWhereAnEdgeRunsThrough) {
  const Rig rig = DepthTestRig();
  DepthImage depth = Depth(rig, 2);
  depth.pixels.colRange(164, 320).setTo(3);  // through the middle of a column of cells
  depth.pixels.rowRange(200, 240).setTo(0);
  const DepthGrid grid = DepthGridMaker(rig).Make(depth);
  EXPECT_EQ(grid.size(), 40 * 30);
  EXPECT_FLOAT_EQ(grid.surface[Cell(grid, 100, 100)], 2);
  EXPECT_FLOAT_EQ(grid.surface[Cell(grid, 250, 100)], 3);
  EXPECT_EQ(grid.surface[Cell(grid, 163, 100)], 0);
  EXPECT_EQ(grid.surface[Cell(grid, 100, 220)], 0);
}

TEST(DepthGrid, LeavesOutWhatIsKnownToMove) {
  const Rig rig = DepthTestRig();
  cv::Mat moving = cv::Mat::zeros(60, 80, CV_8UC1);  // a quarter of the picture's size
  moving(cv::Rect(20, 10, 10, 10)).setTo(1);
  const DepthGrid grid = DepthGridMaker(rig).Make(Depth(rig, 2), moving);
  EXPECT_EQ(grid.surface[Cell(grid, 100, 60)], 0);
  EXPECT_EQ(grid.free[Cell(grid, 100, 60)], 0);
  EXPECT_FLOAT_EQ(grid.surface[Cell(grid, 60, 60)], 2);
}

TEST(DepthGrid, IsFreeUpToTheNearestThingAboutACell) {
  const Rig rig = DepthTestRig();
  DepthImage depth = Depth(rig, 3);
  depth.pixels(cv::Rect(160, 80, 8, 8)).setTo(1);
  const DepthGrid grid = DepthGridMaker(rig).Make(depth);
  for (int y = 12; y < 228; y += kGridCellPx) {
    for (int x = 12; x < 308; x += kGridCellPx) {
      const bool is_near = std::abs(x - 164) <= kGridCellPx && std::abs(y - 84) <= kGridCellPx;
      EXPECT_FLOAT_EQ(grid.free[Cell(grid, static_cast<float>(x), static_cast<float>(y))], is_near ? 1 : 3);
    }
  }
  EXPECT_EQ(grid.free[0], 0) << "about the border not all is known";
}

TEST(DepthGrid, ReadsThePixelThatTheLensPutsThere) {
  Rig rig = DepthTestRig();
  rig.camera.distortion = {0.2, -0.1, 0, 0, 0, 0, 0, 0};
  DepthImage depth = Depth(rig, 2);
  const Eigen::Vector2d ideal_px(40, 32);
  const Eigen::Vector2d px = rig.camera.Distort(ideal_px);
  ASSERT_GT((px - ideal_px).norm(), 4);
  cv::Mat(depth.pixels, cv::Rect(static_cast<int>(px.x()) - 8, static_cast<int>(px.y()) - 8, 16, 16)).setTo(1);
  const DepthGrid grid = DepthGridMaker(rig).Make(depth);
  EXPECT_FLOAT_EQ(grid.surface[Cell(grid, 40, 32)], 1);
}

TEST(IsSeenThrough, HoldsOnlyWhereSomethingClearlyBehindIsSeen) {
  const Rig rig = DepthTestRig();
  const DepthGrid grid = DepthGridMaker(rig).Make(Depth(rig, 3));
  EXPECT_TRUE(IsSeenThrough(grid, rig, {0, 0, 1.5}));
  EXPECT_FALSE(IsSeenThrough(grid, rig, {0, 0, 2.8})) << "within what the sensor can tell";
  EXPECT_FALSE(IsSeenThrough(grid, rig, {0, 0, 3.5})) << "hidden";
  EXPECT_FALSE(IsSeenThrough(grid, rig, {0, 0, -1})) << "behind the camera";
  EXPECT_FALSE(IsSeenThrough(grid, rig, {5, 0, 1.5})) << "outside of the picture";
  EXPECT_FALSE(IsSeenThrough(DepthGridMaker(rig).Make(Depth(rig, 0)), rig, {0, 0, 1.5})) << "nothing was measured";
}

}  // namespace
}  // namespace yorb

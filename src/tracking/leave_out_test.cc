// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/leave_out.h"

#include <gtest/gtest.h>

#include "map/synthetic_world.h"

namespace yorb {
namespace {

DepthGrid WallAt(const Rig& rig, float metres) {
  return DepthGridMaker(rig).Make(
      {cv::Mat(rig.camera.height, rig.camera.width, CV_32FC1, cv::Scalar(static_cast<double>(metres))), 1});
}

TEST(PointsOnMovers, AreInTheCellsButNotBehindThem) {
  const SyntheticWorld world(1);
  const FramePtr frame = world.Look(Rigid3::Identity(), FrameId(0), Timestamp{0}).frame;
  const DepthGrid grid = WallAt(world.rig(), 1);  // nearer than all points
  EXPECT_TRUE(PointsOnMovers(*frame, MovingCells()).empty());
  const MovingCells everywhere(grid, world.rig(), std::vector<uint8_t>(grid.surface.size(), 1));
  EXPECT_TRUE(PointsOnMovers(*frame, everywhere).empty());

  Frame near = *frame;
  near.depth.assign(near.size(), 1.f);
  near.depth.back() = 0;
  std::vector<uint8_t> left_half(grid.surface.size(), 0);
  for (int cell = 0; cell < grid.size(); ++cell) {
    left_half[static_cast<size_t>(cell)] = cell % grid.columns < grid.columns / 2;
  }
  const auto is_on = PointsOnMovers(near, MovingCells(grid, world.rig(), left_half));
  ASSERT_EQ(is_on.size(), near.size());
  const float middle_px = static_cast<float>(grid.columns / 2 * kGridCellPx);
  for (size_t i = 0; i < near.size(); ++i) EXPECT_EQ(is_on[i], near.points_px[i].x() + 0.5f < middle_px);
}

TEST(WithoutRows, KeepsTheRestInItsOrder) {
  const SyntheticWorld world(1);
  const FramePtr frame = world.Look(Rigid3::Identity(), FrameId(0), Timestamp{0}).frame;
  std::vector<bool> is_marked(frame->size(), false);
  for (size_t i = 0; i < is_marked.size(); i += 3) is_marked[i] = true;
  const FramePtr rest = WithoutRows(frame, is_marked);
  ASSERT_EQ(rest->size(), frame->size() - (frame->size() + 2) / 3);
  for (size_t i = 0; i < rest->size(); ++i) {
    const size_t from = i / 2 * 3 + i % 2 + 1;
    EXPECT_EQ(rest->points_px[i], frame->points_px[from]);
    EXPECT_EQ(rest->depth[i], frame->depth[from]);
    EXPECT_EQ(rest->descriptors[i], frame->descriptors[from]);
    bool is_in_grid = false;
    rest->grid.VisitNear(rest->points_px[i].x(), rest->points_px[i].y(), 1,
                         [&](uint32_t index) { is_in_grid |= index == i; });
    EXPECT_TRUE(is_in_grid);
  }
}

TEST(DoubtfulSuspects, AreThoseThatNoLandmarkSpeaksFor) {
  const SyntheticWorld world(1);
  Frame frame = *world.Look(Rigid3::Identity(), FrameId(0), Timestamp{0}).frame;
  frame.num_suspects = frame.size() / 2;
  std::vector<LandmarkId> matches(frame.size());
  for (uint32_t i = 0; i < frame.size(); i += 3) matches[i] = LandmarkId(i);
  const auto is_doubtful = DoubtfulSuspects(frame, matches);
  ASSERT_EQ(is_doubtful.size(), frame.size());
  for (size_t i = 0; i < frame.size(); ++i) EXPECT_EQ(is_doubtful[i], frame.IsSuspect(i) && i % 3 != 0);
}

TEST(WithoutRows, PointsByDepthKeepTheirKeypoints) {
  const std::vector<DepthPoint> points = {{1, {1, 0, 0}}, {2, {2, 0, 0}}, {4, {4, 0, 0}}};
  const std::vector<DepthPoint> kept = WithoutRows(points, {true, false, true, true, false});
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].row, 0u);
  EXPECT_EQ(kept[0].x_in_world.x(), 1);
  EXPECT_EQ(kept[1].row, 1u);
  EXPECT_EQ(kept[1].x_in_world.x(), 4);
}

}  // namespace
}  // namespace yorb

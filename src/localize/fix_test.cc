// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize/fix.h"

#include <gtest/gtest.h>

#include "map/synthetic_world.h"

namespace yorb {
namespace {

/// Four keyframes in one place, a second apart; all points but every third are seen by all of them, the others by the
/// newest alone.
struct OldAndNew {
  Map map;
  std::vector<LandmarkId> landmarks;  ///< a row a point of the world
  std::vector<bool> is_new;
};

OldAndNew MapOf(const SyntheticWorld& world) {
  OldAndNew made;
  made.landmarks.resize(5000);
  made.is_new.resize(5000);
  KeyframeId parent;
  for (uint32_t k = 0; k < 4; ++k) {
    const auto view = world.Look(Rigid3::Identity(), FrameId(k), Timestamp{k * int64_t{1'000'000'000}});
    parent = made.map.AddKeyframe(view.frame, Rigid3::Identity(), parent);
    for (uint32_t i = 0; i < view.points.size(); ++i) {
      const uint32_t point = view.points[i];
      made.is_new[point] = point % 3 != 0;
      if (made.is_new[point] && k < 3) continue;
      LandmarkId& id = made.landmarks[point];
      if (id.IsValid()) made.map.Observe(id, parent, i);
      if (!id.IsValid()) id = made.map.AddLandmark(world.Position(point), parent, i);
    }
  }
  return made;
}

TEST(Fix, WhatStoodForLongOutweighsMoreThatIsNew) {
  const SyntheticWorld world(4);
  OldAndNew made = MapOf(world);
  const auto view = world.Look(Rigid3::Identity(), FrameId(9), Timestamp{int64_t{4'000'000'000}});
  std::vector<LandmarkId> matches(view.frame->size());
  const Eigen::Vector3d moved(0.01, 0, 0);  // someone who walks by
  for (uint32_t i = 0; i < view.points.size(); ++i) {
    const uint32_t point = view.points[i];
    matches[i] = made.landmarks[point];
    if (made.is_new[point] && matches[i].IsValid()) made.map.SetPosition(matches[i], world.Position(point) + moved);
  }
  const Fix fix = FixFromLandmarks(*view.frame, made.map, Rigid3::Identity(), matches, {});
  EXPECT_LT(fix.cam_from_world.translation.norm(), 0.005) << "nearer to the old ones, which are half as many";
}

TEST(Fix, PointsOfTheFrameBeforeStandInWhereThereIsNoLandmark) {
  const SyntheticWorld world(4);
  const OldAndNew made = MapOf(world);
  const auto view = world.Look(Rigid3::Identity(), FrameId(9), Timestamp{int64_t{4'000'000'000}});
  std::vector<LandmarkId> matches(view.frame->size());
  std::vector<DepthPoint> by_depth;
  for (uint32_t i = 0; i < view.points.size(); ++i) {
    if (i % 4 == 0) matches[i] = made.landmarks[view.points[i]];
    if (i % 2 == 0) by_depth.push_back({i, world.Position(view.points[i])});
  }
  const Fix fix = FixFromLandmarks(*view.frame, made.map, Rigid3::Identity(), matches, by_depth);
  EXPECT_EQ(fix.num_in_all(), fix.num_inliers + fix.by_depth.size());
  EXPECT_GT(fix.num_inliers, 50u);
  EXPECT_GT(fix.by_depth.size(), 50u);
  for (const DepthPoint& point : fix.by_depth) EXPECT_FALSE(matches[point.row].IsValid());
  // What landmarks say is not said twice.
  Fix by_landmarks = fix;
  by_landmarks.by_depth.clear();
  EXPECT_TRUE(BesideLandmarks(*view.frame, by_landmarks).isZero());
  EXPECT_GT(BesideLandmarks(*view.frame, fix).diagonal().minCoeff(), 0);
}

}  // namespace
}  // namespace yorb

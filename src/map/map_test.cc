// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "map/synthetic_world.h"

namespace yorb {
namespace {

Rigid3 CameraAt(double x) { return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(-x, 0, 0)}; }

/// A map of `num` keyframes along a line, each of which sees what it should.
struct Built {
  Map map;
  std::vector<KeyframeId> keyframes;
  std::vector<LandmarkId> landmarks;  // a row a point of the world
  std::vector<SyntheticWorld::View> views;
};

Built Build(int num) {
  const SyntheticWorld world(1);
  Built built;
  built.landmarks.resize(5000);
  for (int k = 0; k < num; ++k) {
    const Rigid3 pose = CameraAt(0.1 * k);
    built.views.push_back(world.Look(pose, FrameId(static_cast<uint32_t>(k)), Timestamp{k}));
    const auto& view = built.views.back();
    const KeyframeId parent = built.keyframes.empty() ? KeyframeId() : built.keyframes.back();
    const KeyframeId id = built.map.AddKeyframe(view.frame, pose, parent);
    built.keyframes.push_back(id);
    for (uint32_t i = 0; i < view.points.size(); ++i) {
      LandmarkId& landmark = built.landmarks[view.points[i]];
      if (landmark.IsValid()) {
        EXPECT_TRUE(built.map.Observe(landmark, id, i));
      } else {
        landmark = built.map.AddLandmark(world.Position(view.points[i]), id, i);
      }
    }
  }
  return built;
}

TEST(Map, HoldsItsInvariantsWhileItGrowsAndShrinks) {
  Built built = Build(8);
  ASSERT_EQ(built.map.Check(), "");
  for (const size_t k : {3, 7, 1}) {
    built.map.Remove(built.keyframes[k]);
    ASSERT_EQ(built.map.Check(), "");
  }
  EXPECT_EQ(built.map.num_keyframes(), 5u);
  EXPECT_EQ(built.map.newest_keyframe(), built.keyframes[6]);
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const LandmarkId id = built.landmarks[random.Below(5000)];
    if (!built.map.Find(id)) continue;
    built.map.Remove(id);
  }
  EXPECT_EQ(built.map.Check(), "");
}

TEST(Map, NeighboursCountTheLandmarksThatBothSee) {
  const Built built = Build(2);
  size_t shared = 0;
  for (const LandmarkId id : built.map.Find(built.keyframes[0])->landmarks) {
    shared += built.map.Find(id)->ViewOf(built.keyframes[1]) != nullptr;
  }
  ASSERT_GT(shared, 100u);
  const auto& neighbours = built.map.Find(built.keyframes[0])->neighbours;
  ASSERT_EQ(neighbours.size(), 1u);
  EXPECT_EQ(neighbours[0].weight, static_cast<int>(shared));
  const Keyframe& first = *built.map.Find(built.keyframes[0]);
  EXPECT_EQ(first.NumShared(built.keyframes[1]), static_cast<int>(shared));
  EXPECT_EQ(first.NumShared(KeyframeId(9)), 0);
  EXPECT_EQ(first.WithStrongest(5, 1), (std::vector<KeyframeId>{built.keyframes[1], built.keyframes[0]}));
}

/// Keyframes of one picture in one place, each with landmarks of its own that are merged into those of the first.
TEST(Map, WhatWasMergedIsForgottenWhenNobodyCanAskForIt) {
  Map map;
  const auto view = SyntheticWorld(1).Look(CameraAt(0), FrameId(0), Timestamp{0});
  const KeyframeId first = map.AddKeyframe(view.frame, CameraAt(0), KeyframeId());
  std::vector<LandmarkId> firm;
  for (uint32_t i = 0; i < 10; ++i) firm.push_back(map.AddLandmark({0, 0, 1.0 + i}, first, i));
  std::vector<LandmarkId> merged;
  const int num_keyframes = 3 * static_cast<int>(Map::kMergesRemembered);
  for (int k = 0; k < num_keyframes; ++k) {
    const KeyframeId id = map.AddKeyframe(view.frame, CameraAt(0), first);
    const LandmarkId own = map.AddLandmark({0, 0, 1.0 + k % 10}, id, static_cast<uint32_t>(k % 10));
    map.Merge(own, firm[static_cast<size_t>(k % 10)]);
    merged.push_back(own);
  }
  const MapSnapshot snapshot = map.Snapshot();
  for (int k = 0; k < num_keyframes; ++k) {
    const bool is_young = k >= num_keyframes - 1 - static_cast<int>(Map::kMergesRemembered);
    const LandmarkId own = merged[static_cast<size_t>(k)];
    EXPECT_EQ(snapshot->Resolve(own), is_young ? firm[static_cast<size_t>(k % 10)] : own) << k;
  }
  EXPECT_EQ(snapshot->Check(), "");
}

TEST(Map, ASnapshotKnowsTheKeyframesThatWereThenRemoved) {
  Built built = Build(6);
  built.map.Remove(built.keyframes[2]);
  const MapSnapshot before = built.map.Snapshot();
  built.map.Remove(built.keyframes[3]);
  EXPECT_EQ(before->Surviving(built.keyframes[3]), built.keyframes[3]);
  EXPECT_EQ(built.map.Surviving(built.keyframes[3]), built.keyframes[1]);
  for (const size_t k : {2u, 3u}) {
    EXPECT_NEAR(built.map.CamFromWorld(built.keyframes[k])->translation.x(), -0.1 * static_cast<double>(k), 1e-12);
  }
  EXPECT_FALSE(built.map.CamFromWorld(KeyframeId(6)).has_value());
  EXPECT_FALSE(built.map.CamFromWorld(KeyframeId()).has_value());
}

TEST(Map, SnapshotNeverChanges) {
  Built built = Build(4);
  const MapSnapshot before = built.map.Snapshot();
  const size_t num_landmarks = before->num_landmarks();
  const LandmarkId moved = built.map.Find(built.keyframes[3])->landmarks[0];
  const Eigen::Vector3d position = before->Find(moved)->position;
  built.map.SetPosition(moved, position + Eigen::Vector3d::Ones());
  built.map.SetPose(built.keyframes[2], CameraAt(5));
  built.map.Remove(built.keyframes[1]);
  built.map.AddKeyframe(built.views[0].frame, CameraAt(0), built.keyframes[3]);

  EXPECT_EQ(before->Check(), "");
  EXPECT_EQ(built.map.Check(), "");
  EXPECT_EQ(before->num_keyframes(), 4u);
  EXPECT_EQ(before->num_landmarks(), num_landmarks);
  EXPECT_EQ(before->Find(moved)->position, position);
  EXPECT_NE(before->Find(built.keyframes[1]), nullptr);
  EXPECT_NEAR(before->Find(built.keyframes[2])->cam_from_world.translation.x(), -0.2, 1e-12);
  EXPECT_NE(built.map.Find(moved)->position, position);
}

TEST(Map, MergeKeepsAllObservations) {
  Built built = Build(3);
  // Two landmarks that no keyframe sees both of: one seen by the first alone, one by the last alone.
  const KeyframeId first = built.keyframes[0], last = built.keyframes[2];
  LandmarkId from, into;
  built.map.VisitLandmarks([&](const Landmark& landmark) {
    if (landmark.views.size() != 1) return;
    if (landmark.ViewOf(last)) from = landmark.id;
    if (landmark.ViewOf(first)) into = landmark.id;
  });
  ASSERT_TRUE(from.IsValid() && into.IsValid());
  built.map.Count(from, 10, 5);
  built.map.Merge(from, into);
  EXPECT_EQ(built.map.Find(from), nullptr);
  EXPECT_EQ(built.map.Resolve(from), into);
  ASSERT_EQ(built.map.Find(into)->views.size(), 2u);
  EXPECT_EQ(built.map.Find(into)->num_visible, 12);
  EXPECT_EQ(built.map.Find(into)->num_found, 7);
  EXPECT_EQ(built.map.Check(), "");
}

TEST(Map, RemovedKeyframeFollowsItsParent) {
  Built built = Build(4);
  const Rigid3 relative =
      *built.map.CamFromWorld(built.keyframes[2]) * built.map.CamFromWorld(built.keyframes[1])->Inverse();
  built.map.Remove(built.keyframes[2]);
  built.map.Remove(built.keyframes[1]);
  built.map.SetPose(built.keyframes[0], CameraAt(7));
  const Rigid3 expected = relative * (CameraAt(0.1) * CameraAt(0).Inverse()) * CameraAt(7);
  const auto pose = built.map.CamFromWorld(built.keyframes[2]);
  ASSERT_TRUE(pose.has_value());
  EXPECT_LT((pose->translation - expected.translation).norm(), 1e-12);
  EXPECT_EQ(built.map.Surviving(built.keyframes[2]), built.keyframes[0]);
  EXPECT_FALSE(built.map.CamFromWorld(KeyframeId(99)).has_value());
}

TEST(Map, SeenByNamesEachLandmarkOnce) {
  const Built built = Build(3);
  const std::vector<LandmarkId> ids = built.map.SeenBy(built.keyframes);
  EXPECT_EQ(ids.size(), built.map.num_landmarks());
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
}

TEST(Map, ALandmarkGoesWithItsLastView) {
  Built built = Build(2);
  const LandmarkId id = built.map.Find(built.keyframes[0])->landmarks[0];
  const std::vector<LandmarkView> views = built.map.Find(id)->views;
  for (const LandmarkView& view : views) built.map.Unobserve(id, view.keyframe);
  EXPECT_EQ(built.map.Find(id), nullptr);
  EXPECT_EQ(built.map.Check(), "");
}

TEST(Map, RefusesASecondViewOfOneKeyframe) {
  Built built = Build(2);
  const Keyframe& keyframe = *built.map.Find(built.keyframes[0]);
  const LandmarkId a = keyframe.landmarks[0], b = keyframe.landmarks[1];
  EXPECT_FALSE(built.map.Observe(a, keyframe.id, 1));
  built.map.Unobserve(b, keyframe.id);
  EXPECT_FALSE(built.map.Observe(a, keyframe.id, 1));
  EXPECT_EQ(built.map.Check(), "");
}

TEST(PagedTable, GivesBackPagesWithoutRowsAndNeverAnIdTwice) {
  PagedTable<int> table;
  for (int i = 0; i < 200; ++i) EXPECT_EQ(table.Add(i).value(), static_cast<uint32_t>(i));
  for (uint32_t i = 0; i < 128; ++i) table.Remove(Id<int>(i));
  EXPECT_EQ(table.size(), 72u);
  EXPECT_EQ(table.Find(Id<int>(5)), nullptr);
  EXPECT_EQ(*table.Find(Id<int>(150)), 150);
  EXPECT_EQ(table.Add(7).value(), 200u);
  int count = 0;
  table.Visit([&](int) { ++count; });
  EXPECT_EQ(count, 73);
}

}  // namespace
}  // namespace yorb

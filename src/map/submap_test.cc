// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "map/correction.h"
#include "map/test_map.h"

namespace yorb {
namespace {

Rigid3 SomeMotion() { return {RotationFromVector({0.1, -0.4, 0.2}), Eigen::Vector3d(1, 2, -0.5)}; }

double Distance(const Rigid3& a, const Rigid3& b) {
  const Rigid3 off = a * b.Inverse();
  return off.translation.norm() + off.RotationAngle();
}

TEST(Submaps, EachHasARootOfItsOwn) {
  const SyntheticWorld world(1);
  Map map;
  const auto one = AddSubmap(map, world, PosesAlongX(4, 0.1));
  const auto other = AddSubmap(map, world, PosesAlongX(3, 0.1), SomeMotion());
  EXPECT_EQ(map.Check(), "");
  for (const KeyframeId id : one) EXPECT_EQ(map.Find(id)->root, one[0]);
  for (const KeyframeId id : other) EXPECT_EQ(map.Find(id)->root, other[0]);
}

TEST(Submaps, JoinTurnsTheWayToTheOldRootRoundAndKeepsAllChildren) {
  const SyntheticWorld world(1);
  Map map;
  const auto one = AddSubmap(map, world, PosesAlongX(4, 0.1));
  const auto other = AddSubmap(map, world, PosesAlongX(4, 0.1));
  map.Join(other[2], one[1]);
  EXPECT_EQ(map.Check(), "");
  EXPECT_EQ(map.Find(other[2])->parent, one[1]);
  EXPECT_EQ(map.Find(other[1])->parent, other[2]);
  EXPECT_EQ(map.Find(other[0])->parent, other[1]);
  EXPECT_EQ(map.Find(other[3])->parent, other[2]);
  for (const KeyframeId id : other) EXPECT_EQ(map.Find(id)->root, one[0]);
  // The old root is a keyframe like any other now.
  map.Remove(other[0]);
  map.Remove(other[2]);
  EXPECT_EQ(map.Check(), "");
}

TEST(Submaps, ALoopIsKnownAtBothEndsAndGoesWithEither) {
  const SyntheticWorld world(1);
  Map map;
  const auto keyframes = AddSubmap(map, world, PosesAlongX(5, 0.1));
  map.AddLoop(keyframes[4], keyframes[0]);
  EXPECT_EQ(map.Check(), "");
  EXPECT_EQ(map.num_loops(), 1u);
  map.Remove(keyframes[4]);
  EXPECT_EQ(map.Check(), "");
  EXPECT_TRUE(map.Find(keyframes[0])->loops.empty());
  EXPECT_EQ(map.num_loops(), 1u);  // it was closed all the same
}

TEST(MoveMap, KeyframesThatCameSinceFollowTheirNearestCorrectedAncestorAndLandmarksTheirReference) {
  const SyntheticWorld world(1);
  Map map;
  const auto keyframes = AddSubmap(map, world, PosesAlongX(5, 0.1));
  const auto apart = AddSubmap(map, world, PosesAlongX(2, 0.1), SomeMotion());
  const MapSnapshot before = map.Snapshot();
  const Rigid3 shift(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0, 0, 0.5)), turn = SomeMotion();
  Correction correction;
  correction.poses = {{keyframes[1], before->Find(keyframes[1])->cam_from_world * shift},
                      {keyframes[2], before->Find(keyframes[2])->cam_from_world * turn},
                      {KeyframeId(77), Rigid3()}};
  const LandmarkId given = before->SeenBy({keyframes[1]}).front();
  correction.points = {{given, Eigen::Vector3d(1, 2, 3)}, {LandmarkId(999999), Eigen::Vector3d::Zero()}};
  MoveMap(map, correction);
  EXPECT_EQ(map.Check(), "");
  const auto moved_by = [&](KeyframeId id) {
    return before->Find(id)->cam_from_world.Inverse() * map.Find(id)->cam_from_world;
  };
  EXPECT_LT(Distance(moved_by(keyframes[0]), Rigid3()), 1e-12);  // above all that is corrected
  EXPECT_LT(Distance(moved_by(keyframes[1]), shift), 1e-12);
  EXPECT_LT(Distance(moved_by(keyframes[2]), turn), 1e-12);
  EXPECT_LT(Distance(moved_by(keyframes[3]), turn), 1e-12);
  EXPECT_LT(Distance(moved_by(keyframes[4]), turn), 1e-12);
  EXPECT_LT(Distance(moved_by(apart[1]), Rigid3()), 1e-12);
  EXPECT_EQ(map.Find(given)->position, Eigen::Vector3d(1, 2, 3));
  before->VisitLandmarks([&](const Landmark& landmark) {
    if (landmark.id == given) return;
    const Eigen::Vector3d in_cam = before->Find(landmark.reference)->cam_from_world * landmark.position;
    const Eigen::Vector3d now = map.Find(landmark.reference)->cam_from_world * map.Find(landmark.id)->position;
    EXPECT_LT((in_cam - now).norm(), 1e-9);
  });
}

}  // namespace
}  // namespace yorb

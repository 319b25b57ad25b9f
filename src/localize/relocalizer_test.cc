// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize/relocalizer.h"

#include <gtest/gtest.h>

#include "map/synthetic_world.h"

namespace yorb {
namespace {

Rigid3 Looking(double x, double turn) { return {RotationFromVector({0, turn, 0}), Eigen::Vector3d(-x, 0, 0)}; }

/// A map of a few keyframes that know the true landmarks they see.
Map MapOf(const SyntheticWorld& world, const std::vector<Rigid3>& poses) {
  Map map;
  std::vector<LandmarkId> landmark_of(5000);
  KeyframeId parent;
  for (size_t k = 0; k < poses.size(); ++k) {
    const auto view = world.Look(poses[k], FrameId(static_cast<uint32_t>(k)), Timestamp{static_cast<int64_t>(k)});
    parent = map.AddKeyframe(view.frame, poses[k], parent);
    for (uint32_t i = 0; i < view.points.size(); ++i) {
      LandmarkId& id = landmark_of[view.points[i]];
      if (!id.IsValid()) {
        id = map.AddLandmark(world.Position(view.points[i]), parent, i);
      } else {
        map.Observe(id, parent, i);
      }
    }
  }
  return map;
}

TEST(Relocalize, FindsAFrameFarFromTheLastOne) {
  SyntheticWorldOptions noisy;
  noisy.pixel_noise = 0.5;
  const SyntheticWorld world(4, noisy);
  const Map map = MapOf(world, {Looking(0, 0), Looking(0.2, 0.1), Looking(0.4, 0.8), Looking(0.5, 1.2)});
  const Rigid3 truth = Looking(0.1, 0.05);
  const auto view = world.Look(truth, FrameId(50), Timestamp{50});
  const auto fix = Relocalize(*view.frame, map, NewestAndSomeOlder(map, view.frame->id), RecognitionTerms(), Random(1));
  ASSERT_TRUE(fix.has_value());
  EXPECT_LT((fix->cam_from_world.translation - truth.translation).norm(), 0.01);
  EXPECT_GE(fix->num_inliers, 50u);
}

TEST(Relocalize, GivesNoPoseInAnotherPlace) {
  const SyntheticWorld world(4), elsewhere(5);
  const Map map = MapOf(world, {Looking(0, 0), Looking(0.2, 0.1)});
  for (uint32_t k = 0; k < 20; ++k) {
    const auto view = elsewhere.Look(Looking(0.05 * k, 0.02 * k), FrameId(k), Timestamp{k});
    EXPECT_FALSE(Relocalize(*view.frame, map, NewestAndSomeOlder(map, view.frame->id), RecognitionTerms(), Random(1, k))
                     .has_value());
  }
}

TEST(Relocalize, TheSameSeedGivesTheSameBits) {
  const SyntheticWorld world(4);
  const Map map = MapOf(world, {Looking(0, 0), Looking(0.2, 0.1)});
  const auto view = world.Look(Looking(0.3, 0.0), FrameId(9), Timestamp{9});
  const auto a =
      Relocalize(*view.frame, map, NewestAndSomeOlder(map, view.frame->id), RecognitionTerms(), Random(3, 9));
  const auto b =
      Relocalize(*view.frame, map, NewestAndSomeOlder(map, view.frame->id), RecognitionTerms(), Random(3, 9));
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->cam_from_world.translation, b->cam_from_world.translation);
  EXPECT_EQ(a->matches, b->matches);
}

}  // namespace
}  // namespace yorb

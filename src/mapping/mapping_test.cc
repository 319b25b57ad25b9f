// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "map/synthetic_world.h"
#include "mapping/cull.h"
#include "mapping/insert.h"
#include "mapping/mapper.h"
#include "mapping/triangulate_new.h"

namespace yorb {
namespace {

Rigid3 CameraAt(double x) { return {Eigen::Quaterniond::Identity(), Eigen::Vector3d(-x, 0, 0)}; }

Proposal First(const SyntheticWorld::View& view) {
  return {view.frame, KeyframeId(), Rigid3::Identity(), std::vector<LandmarkId>(view.frame->size()), {}};
}

TEST(InsertKeyframe, SkipsMatchesThatAreGoneAndFollowsMerges) {
  const SyntheticWorld world(1);
  const auto view = world.Look(CameraAt(0), FrameId(0), Timestamp{0});
  const auto next = world.Look(CameraAt(0.05), FrameId(1), Timestamp{33});
  Map map;
  const KeyframeId first = InsertKeyframe(map, First(view));
  const std::vector<LandmarkId> landmarks = AddLandmarksByDepth(map, first);
  ASSERT_GT(landmarks.size(), 100u);
  const LandmarkId gone = landmarks[0], from = landmarks[1], into = landmarks[2];

  Proposal proposal{next.frame, first, CameraAt(0.05), std::vector<LandmarkId>(next.frame->size()), {}};
  proposal.matches[0] = gone;
  proposal.matches[1] = from;
  proposal.counts = {{gone, 3, 3}, {into, 5, 4}};
  map.Remove(gone);
  map.Merge(from, into);
  const KeyframeId second = InsertKeyframe(map, proposal);
  EXPECT_EQ(map.Check(), "");
  EXPECT_FALSE(map.Find(second)->landmarks[0].IsValid());
  EXPECT_EQ(map.Find(second)->landmarks[1], into);
  EXPECT_EQ(map.Find(into)->num_visible, 1 + 1 + 5);
}

TEST(TriangulateNew, FindsPointsWithoutDepthWhereTheyAre) {
  SyntheticWorldOptions options;
  options.depth_share = 0;
  const SyntheticWorld world(2, options);
  const auto a = world.Look(CameraAt(0), FrameId(0), Timestamp{0});
  const auto b = world.Look(CameraAt(0.3), FrameId(1), Timestamp{33});
  Map map;
  const KeyframeId first = map.AddKeyframe(a.frame, CameraAt(0), KeyframeId());
  const KeyframeId second = map.AddKeyframe(b.frame, CameraAt(0.3), first);
  // One landmark that both see makes them neighbours.
  for (uint32_t i = 0; i < a.points.size(); ++i) {
    const auto same = std::find(b.points.begin(), b.points.end(), a.points[i]);
    if (same == b.points.end()) continue;
    map.Observe(map.AddLandmark(world.Position(a.points[i]), first, i), second,
                static_cast<uint32_t>(same - b.points.begin()));
    break;
  }
  const std::vector<LandmarkId> added = TriangulateNew(map, second, 10);
  EXPECT_EQ(map.Check(), "");
  EXPECT_GT(added.size(), 100u);
  size_t num_right = 0;
  for (const LandmarkId id : added) {
    const Landmark& landmark = *map.Find(id);
    const auto truth = world.Position(b.points[landmark.ViewOf(second)->index]);
    num_right += (landmark.position - truth).norm() < 0.01 * truth.norm();
  }
  EXPECT_GT(num_right, 0.98 * static_cast<double>(added.size()));
}

TEST(CullRecentLandmarks, TakesOutThoseThatAreHardlyFound) {
  const SyntheticWorld world(1);
  Map map;
  const KeyframeId first = InsertKeyframe(map, First(world.Look(CameraAt(0), FrameId(0), Timestamp{0})));
  const std::vector<LandmarkId> landmarks = AddLandmarksByDepth(map, first);
  map.Count(landmarks[0], 20, 2);
  const auto left = CullRecentLandmarks(map, landmarks);
  EXPECT_EQ(map.Find(landmarks[0]), nullptr);
  EXPECT_EQ(left.size(), landmarks.size() - 1);
}

TEST(CullRecentLandmarks, LeavesThoseOfAnotherSubMapAlone) {
  const SyntheticWorld world(1);
  Map map;
  const KeyframeId first = InsertKeyframe(map, First(world.Look(CameraAt(0), FrameId(0), Timestamp{0})));
  const std::vector<LandmarkId> left_behind = AddLandmarksByDepth(map, first);
  for (uint32_t k = 1; k < 4; ++k) InsertKeyframe(map, First(world.Look(CameraAt(0), FrameId(k), Timestamp{k})));
  EXPECT_TRUE(CullRecentLandmarks(map, left_behind).empty()) << "no more is to be heard of them";
  for (const LandmarkId id : left_behind) EXPECT_TRUE(map.Find(id));
}

TEST(RemoveGone, TakesOutWhatWasOftenSeenToHaveGone) {
  const SyntheticWorld world(4);
  const auto view = world.Look(CameraAt(0), FrameId(0), Timestamp{0});
  Map map;
  const std::vector<LandmarkId> landmarks = AddLandmarksByDepth(map, InsertKeyframe(map, First(view)));
  const LandmarkId gone = landmarks[0], merged = landmarks[1], into = landmarks[2];
  const LandmarkId found = landmarks[3], rarely = landmarks[4];
  map.Merge(merged, into);
  EXPECT_EQ(RemoveGone(map, {{gone, 5, 1, 4}, {merged, 5, 0, 3}, {found, 9, 5, 4}, {rarely, 2, 0, 2}}), 2u);
  EXPECT_FALSE(map.Find(gone) || map.Find(into));
  EXPECT_TRUE(map.Find(found) && map.Find(rarely));
  EXPECT_EQ(RemoveGone(map, {{gone, 5, 1, 4}}), 0u);
  EXPECT_EQ(map.Check(), "");
}

TEST(Mapper, NeedsNoTieBetweenKeyframesThatHaveBecomeOne) {
  const SyntheticWorld world(1);
  Map map;
  const KeyframeId older = InsertKeyframe(map, First(world.Look(CameraAt(0), FrameId(0), Timestamp{0})));
  const KeyframeId newer = map.AddKeyframe(world.Look(CameraAt(1), FrameId(1), Timestamp{1}).frame, CameraAt(1), older);
  map.Remove(newer);  // culled between recognition and correction
  Mapper mapper({}, nullptr, map);
  Correction correction;
  correction.place = SamePlace{newer, older};
  mapper.Apply(correction);
  EXPECT_EQ(mapper.Snapshot()->Check(), "");
}

/// Maps a row of views as a tracker with perfect matches and slightly wrong poses would propose them.
TEST(Mapper, PullsWrongPosesRightAndKeepsTheInvariants) {
  SyntheticWorldOptions options;
  options.pixel_noise = 0.3;
  options.depth_noise = 0.3;
  const SyntheticWorld world(6, options);
  Mapper mapper{MappingOptions()};
  Random random(8);
  std::vector<LandmarkId> landmark_of(5000);
  double worst = 0, worst_proposed = 0;
  for (int k = 0; k < 8; ++k) {
    const Rigid3 truth = CameraAt(0.15 * k);
    const auto view = world.Look(truth, FrameId(static_cast<uint32_t>(k)), Timestamp{k * 100000000});
    Proposal proposal = First(view);
    if (k > 0) {
      const MapSnapshot map = mapper.Snapshot();
      proposal.reference = map->newest_keyframe();
      Rigid3 wrong = truth;
      wrong.translation += 0.01 * Eigen::Vector3d(random.Gaussian(), random.Gaussian(), random.Gaussian());
      worst_proposed = std::max(worst_proposed, (wrong.translation - truth.translation).norm());
      proposal.cam_from_reference = wrong * map->CamFromWorld(proposal.reference)->Inverse();
      for (uint32_t i = 0; i < view.points.size(); ++i) proposal.matches[i] = map->Resolve(landmark_of[view.points[i]]);
    }
    mapper.Handle(proposal, {});
    const MapSnapshot map = mapper.Snapshot();
    ASSERT_EQ(map->Check(), "") << "after keyframe " << k;
    const Keyframe& newest = *map->Find(map->newest_keyframe());
    for (uint32_t i = 0; i < view.points.size(); ++i) {
      if (newest.landmarks[i].IsValid()) landmark_of[view.points[i]] = newest.landmarks[i];
    }
    worst = std::max(worst, (newest.cam_from_world.translation - truth.translation).norm());
  }
  EXPECT_GT(worst_proposed, 0.02);
  EXPECT_LT(worst, 0.008);
}

TEST(CullKeyframes, RemovesOneOfManyThatSeeTheSame) {
  const SyntheticWorld world(1);
  Map map;
  std::vector<LandmarkId> landmark_of(5000);
  KeyframeId newest;
  for (uint32_t k = 0; k < 6; ++k) {
    const auto view = world.Look(CameraAt(0.001 * k), FrameId(k), Timestamp{k});
    newest = map.AddKeyframe(view.frame, CameraAt(0.001 * k), newest);
    for (uint32_t i = 0; i < view.points.size(); ++i) {
      LandmarkId& id = landmark_of[view.points[i]];
      if (id.IsValid()) {
        map.Observe(id, newest, i);
      } else {
        id = map.AddLandmark(world.Position(view.points[i]), newest, i);
      }
    }
  }
  CullKeyframes(map, newest, 0.9);
  EXPECT_EQ(map.Check(), "");
  EXPECT_LT(map.num_keyframes(), 6u);
  EXPECT_GE(map.num_keyframes(), 3u);
  EXPECT_NE(map.Find(KeyframeId(0)), nullptr);
}

TEST(InsertKeyframe, KeepsWhatTheTrackerKnowsBesideLandmarks) {
  const SyntheticWorld world(1);
  const auto view = world.Look(CameraAt(0), FrameId(0), Timestamp{0});
  const auto next = world.Look(CameraAt(0.05), FrameId(1), Timestamp{33});
  Map map;
  const KeyframeId first = InsertKeyframe(map, First(view));
  EXPECT_FALSE(map.Find(first)->tie);
  Proposal proposal{next.frame, first, CameraAt(0.05), std::vector<LandmarkId>(next.frame->size()), {}};
  EXPECT_FALSE(map.Find(InsertKeyframe(map, proposal))->tie) << "nothing is known";
  proposal.information = 7 * Matrix6d::Identity();
  const KeyframeId tied = InsertKeyframe(map, proposal);
  ASSERT_TRUE(map.Find(tied)->tie);
  EXPECT_EQ(map.Find(tied)->tie->other, first);
  EXPECT_EQ(map.Find(tied)->tie->information, proposal.information);
  EXPECT_LT((map.Find(tied)->tie->cam_from_other.translation - CameraAt(0.05).translation).norm(), 1e-12);
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Looper and mapper together on maps with exact truth: what no single room can promise.
#include <gtest/gtest.h>

#include "looping/looper.h"
#include "map/test_map.h"
#include "mapping/mapper.h"
#include "places/test_descriptors.h"

namespace yorb {
namespace {

Rigid3 Drift() { return {RotationFromVector({0.01, -0.05, 0.02}), Eigen::Vector3d(0.08, -0.05, 0.06)}; }

/// Gives a mapper the map, with bags, and lets a looper look at its newest keyframe.
class Looping : public testing::Test {
 protected:
  std::optional<Correction> LookAtNewest(const Map& map) {
    vocabulary_ = SmallVocabulary();
    mapper_.emplace(MappingOptions(), vocabulary_, Map::Continuing(map));
    looper_.emplace(LoopingOptions(), vocabulary_, 1);
    return looper_->Look(map.newest_keyframe(), *mapper_->Snapshot());
  }

  VocabularyPtr vocabulary_;
  std::optional<Mapper> mapper_;
  std::optional<Looper> looper_;
};

double DistanceBetween(const Rigid3& a, const Rigid3& b) {
  const Rigid3 off = a * b.Inverse();
  return off.translation.norm() + off.RotationAngle();
}

/// Two visits to one place, the second with the drift of the way between them.
struct TwoVisits {
  Map map;
  std::vector<KeyframeId> first, second;
};

TwoVisits VisitTwice(const SyntheticWorld& first_world, const SyntheticWorld& second_world, bool is_one_map,
                     double step_m = 0.3) {
  TwoVisits visits;
  visits.first = AddSubmap(visits.map, first_world, PosesAlongX(6, step_m));
  visits.second = AddSubmap(visits.map, second_world, PosesAlongX(6, step_m), Drift());
  if (is_one_map) visits.map.Join(visits.second.front(), visits.first.back());
  return visits;
}

TEST_F(Looping, ClosesALoopAndTheMapperFusesWhatIsOne) {
  const SyntheticWorld world(1);
  TwoVisits visits = VisitTwice(world, world, true);
  const size_t num_before = visits.map.num_landmarks();
  const auto correction = LookAtNewest(visits.map);
  ASSERT_TRUE(correction.has_value());
  ASSERT_TRUE(correction->place.has_value());
  mapper_->Apply(*correction);
  const MapSnapshot after = mapper_->Snapshot();
  EXPECT_EQ(after->Check(), "");
  EXPECT_EQ(after->num_loops(), 1u);
  // What is seen twice is one landmark now, and the two visits lie on each other.
  EXPECT_LT(after->num_landmarks(), num_before * 3 / 4);
  for (size_t i = 0; i < visits.first.size(); ++i) {
    const Rigid3 one = after->Find(visits.first[i])->cam_from_world,
                 other = after->Find(visits.second[i])->cam_from_world;
    EXPECT_LT(DistanceBetween(one, other), 0.03) << i;
  }
  ASSERT_TRUE(looper_->WantsToAdjust());
  const auto adjusted = looper_->Adjust(*after, {});
  ASSERT_TRUE(adjusted.has_value());
  EXPECT_FALSE(looper_->WantsToAdjust());
  mapper_->Apply(*adjusted);
  EXPECT_EQ(mapper_->Snapshot()->Check(), "");
  for (size_t i = 0; i < visits.first.size(); ++i) {
    const Rigid3 other = mapper_->Snapshot()->Find(visits.second[i])->cam_from_world;
    EXPECT_LT(DistanceBetween(PosesAlongX(6, 0.3)[i], other), 0.003) << i;
  }
}

TEST_F(Looping, JoinsASubmapToTheElderOneInItsWorld) {
  const SyntheticWorld world(1);
  const TwoVisits visits = VisitTwice(world, world, false);
  const auto correction = LookAtNewest(visits.map);
  ASSERT_TRUE(correction.has_value());
  mapper_->Apply(*correction);
  const MapSnapshot after = mapper_->Snapshot();
  EXPECT_EQ(after->Check(), "");
  EXPECT_EQ(after->num_loops(), 0u);
  for (size_t i = 0; i < visits.first.size(); ++i) {
    EXPECT_EQ(after->Find(visits.second[i])->root, visits.first[0]);
    EXPECT_LT(DistanceBetween(PosesAlongX(6, 0.3)[i], after->Find(visits.second[i])->cam_from_world), 0.003) << i;
  }
}

TEST_F(Looping, FindsNothingInAnotherRoom) {
  const SyntheticWorld world(1), other(2);
  EXPECT_FALSE(LookAtNewest(VisitTwice(world, other, true).map).has_value());
  EXPECT_FALSE(LookAtNewest(VisitTwice(world, other, false).map).has_value());
}

TEST_F(Looping, ARecognitionThatAsksForMoreDriftThanThePathCanHaveIsNone) {
  const SyntheticWorld world(1);
  Map map;
  const auto first = AddSubmap(map, world, PosesAlongX(4, 0.05));
  const auto second = AddSubmap(map, world, PosesAlongX(4, 0.05), {Eigen::Quaterniond::Identity(), {0, 0, 0.5}});
  map.Join(second.front(), first.back());
  EXPECT_FALSE(LookAtNewest(map).has_value());
}

TEST_F(Looping, AFewLandmarksDoWhereAllAreSeenAndThereIsADriftToJudge) {
  SyntheticWorldOptions sparse;
  sparse.num_points = 650;
  const SyntheticWorld world(1, sparse);
  for (const bool is_one_map : {true, false}) {
    const TwoVisits visits = VisitTwice(world, world, is_one_map, 0.1);
    const size_t num_seen = visits.map.Find(visits.second.back())->frame->size();
    ASSERT_LT(num_seen, static_cast<size_t>(LoopingOptions().min_inliers));
    ASSERT_GT(num_seen, static_cast<size_t>(LoopingOptions().min_inliers) * 2 / 3);
    EXPECT_EQ(LookAtNewest(visits.map).has_value(), is_one_map);
  }
}

TEST_F(Looping, TwoGlimpsesOfOnePlaceAgreeAndOthersDoNot) {
  const SyntheticWorld world(1);
  const TwoVisits visits = VisitTwice(world, world, true);
  const Map& map = visits.map;
  // What two keyframes of the second visit would find in the world of the first, each by itself.
  const auto pose = [](size_t i) { return PosesAlongX(6, 0.3)[i]; };
  const Recognition recognition{visits.second[5], visits.first[5], pose(5), 50, 0.3};
  const Glimpse right{visits.second[3], visits.first[2], pose(3) * pose(2).Inverse()};
  EXPECT_TRUE(Agrees(map, recognition, right));
  Glimpse wrong = right;
  wrong.newer_from_older.translation.z() += 0.3;
  EXPECT_FALSE(Agrees(map, recognition, wrong));
  EXPECT_FALSE(Agrees(map, recognition, {visits.second[5], visits.first[5], pose(5) * pose(5).Inverse()}))
      << "one keyframe is no second witness";
  EXPECT_FALSE(Agrees(map, recognition, {KeyframeId(1000), visits.first[2], right.newer_from_older})) << "it is gone";
}

TEST_F(Looping, IsSilentWithoutAVocabularyAndWhenSwitchedOff) {
  LoopingOptions off;
  off.close_loops = false;
  EXPECT_FALSE(Looper(off, SmallVocabulary(), 1).IsActive());
  EXPECT_FALSE(Looper(LoopingOptions(), nullptr, 1).IsActive());
}

/// A picture of which the middle shows one world and the rest another: a poster on a wall.
FramePtr WithPoster(const SyntheticWorld& poster, const SyntheticWorld& room, const Rigid3& pose, uint32_t number) {
  const auto seen = poster.Look(pose, FrameId(number), Timestamp{int64_t{number} * 100000000}).frame;
  const auto around = room.Look(pose, FrameId(number), Timestamp{int64_t{number} * 100000000}).frame;
  auto frame = std::make_shared<Frame>(*around);
  frame->keypoints.clear(), frame->points_px.clear(), frame->depth.clear(), frame->right_px.clear();
  frame->descriptors.clear();
  const auto take = [&](const Frame& from, bool wants_poster) {
    for (size_t i = 0; i < from.size(); ++i) {
      const Eigen::Vector2f& px = from.points_px[i];
      const bool is_poster = std::abs(px.x() - 320) < 130 && std::abs(px.y() - 240) < 110;
      if (is_poster != wants_poster) continue;
      frame->keypoints.push_back(from.keypoints[i]);
      frame->points_px.push_back(px);
      frame->depth.push_back(from.depth[i]);
      frame->right_px.push_back(from.right_px[i]);
      frame->descriptors.push_back(from.descriptors[i]);
    }
  };
  take(*seen, true);
  take(*around, false);
  frame->grid = Grid(frame->bounds, frame->points_px);
  return frame;
}

TEST_F(Looping, APosterOnTwoWallsIsNoPlace) {
  const SyntheticWorld poster(1), one(2), other(3);
  Map map;
  for (const SyntheticWorld* room : {&one, &other}) {
    KeyframeId parent;
    std::vector<LandmarkId> landmarks;
    for (int k = 0; k < 4; ++k) {  // from one place, so that the same points come in the same order
      const FramePtr frame = WithPoster(poster, *room, Rigid3(), map.next_keyframe().value());
      parent = map.AddKeyframe(frame, Rigid3(), parent);
      for (uint32_t i = 0; i < frame->size(); ++i) {
        if (k == 0) {
          landmarks.push_back(map.AddLandmark(frame->PointInCam(i), parent, i));
        } else {
          map.Observe(landmarks[i], parent, i);
        }
      }
    }
  }
  ASSERT_EQ(map.Check(), "");
  EXPECT_FALSE(LookAtNewest(map).has_value());
}

}  // namespace
}  // namespace yorb

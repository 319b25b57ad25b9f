// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/map_bundle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "map/synthetic_world.h"
#include "optimize/global_bundle.h"
#include "optimize/local_bundle.h"
#include "optimize/test_lines.h"
#include "optimize/test_problems.h"

namespace yorb {
namespace {

/// A camera walks along a wall and turns a little; every keyframe but the first is off, and so are the landmarks.
class MapBundleTest : public testing::Test {
 protected:
  static constexpr int kKeyframes = 8;

  void SetUp() override {
    Random random(5);
    std::map<uint32_t, LandmarkId> landmark_of;
    for (int k = 0; k < kKeyframes; ++k) {
      const Rigid3 pose(RotationFromVector({0, 0.05 * k, 0}), Eigen::Vector3d(-0.3 * k, 0, 0));
      const auto view = world_.Look(pose, FrameId(static_cast<uint32_t>(k)), Timestamp{k});
      const Rigid3 off = k == 0 ? pose : RandomPose(random, 0.01, 0.02) * pose;
      const KeyframeId parent = k == 0 ? KeyframeId() : keyframes_.back();
      keyframes_.push_back(map_.AddKeyframe(view.frame, off, parent));
      truth_.push_back(pose);
      for (uint32_t i = 0; i < view.points.size(); ++i) {
        const auto known = landmark_of.find(view.points[i]);
        if (known != landmark_of.end()) {
          map_.Observe(known->second, keyframes_.back(), i);
        } else {
          const Eigen::Vector3d x = world_.Position(view.points[i]) + InCube(random, 0.03);
          landmark_of[view.points[i]] = map_.AddLandmark(x, keyframes_.back(), i);
        }
      }
    }
    ASSERT_EQ(map_.Check(), "");
  }

  double Error(KeyframeId id, const Rigid3& pose) const {
    const auto row = std::find(keyframes_.begin(), keyframes_.end(), id) - keyframes_.begin();
    return (pose.OriginInSource() - truth_[static_cast<size_t>(row)].OriginInSource()).norm();
  }

  /// Gives a keyframe landmarks of its own in place of those that others see, too.
  void LeaveAlone(KeyframeId id) {
    const std::vector<LandmarkId> seen = map_.Find(id)->landmarks;
    for (uint32_t i = 0; i < seen.size(); ++i) {
      if (!seen[i].IsValid() || map_.Find(seen[i])->views.size() == 1) continue;
      const Eigen::Vector3d x = map_.Find(seen[i])->position;
      map_.Unobserve(seen[i], id);
      map_.AddLandmark(x, id, i);
    }
  }

  /// Where local adjustment around a keyframe puts it; nothing where it does not move it.
  std::optional<Rigid3> AdjustedAround(KeyframeId id) const {
    const LocalBundle bundle = AdjustLocally(map_, id, {}, {});
    for (const auto& [moved, pose] : bundle.poses) {
      if (moved == id) return pose;
    }
    return std::nullopt;
  }

  SyntheticWorld world_{1};
  Map map_;
  std::vector<KeyframeId> keyframes_;
  std::vector<Rigid3> truth_;
};

TEST_F(MapBundleTest, GloballyAllKeyframesButTheFirstAndAllLandmarksComeBackToTruth) {
  const GlobalBundle bundle = AdjustGlobally(map_, keyframes_);
  ASSERT_EQ(bundle.poses.size(), size_t{kKeyframes - 1});
  for (const auto& [id, pose] : bundle.poses) {
    EXPECT_NE(id, keyframes_.front());
    EXPECT_GT(Error(id, map_.Find(id)->cam_from_world), 1e-3);
    EXPECT_LT(Error(id, pose), 1e-4);
  }
  EXPECT_EQ(bundle.points.size(), map_.num_landmarks());
  EXPECT_EQ(bundle.outliers.size(), 0u);
  EXPECT_LT(bundle.final_cost, 1e-6 * bundle.initial_cost);
  EXPECT_FALSE(bundle.was_stopped);
}

TEST_F(MapBundleTest, ACallersChoiceIsHeldInPlaceOfTheFirst) {
  GlobalBundleOptions options;
  options.held = keyframes_[3];
  const GlobalBundle bundle = AdjustGlobally(map_, keyframes_, options);
  for (const auto& [id, pose] : bundle.poses) EXPECT_NE(id, keyframes_[3]);
  EXPECT_EQ(bundle.poses.size(), size_t{kKeyframes - 1});
}

TEST_F(MapBundleTest, KeyframesThatAreGoneOrNamedTwiceMakeNoDifference) {
  const KeyframeId gone = keyframes_.back();
  map_.Remove(gone);
  std::vector<KeyframeId> left(keyframes_.begin(), keyframes_.end() - 1);
  const GlobalBundle expected = AdjustGlobally(map_, left);
  left.insert(left.begin(), {gone, left[2]});
  const GlobalBundle bundle = AdjustGlobally(map_, left);
  ASSERT_EQ(bundle.poses.size(), expected.poses.size());
  for (size_t k = 0; k < bundle.poses.size(); ++k) {
    EXPECT_EQ(bundle.poses[k].first, expected.poses[k].first);
    EXPECT_EQ(bundle.poses[k].second.translation, expected.poses[k].second.translation);
  }
  EXPECT_TRUE(AdjustGlobally(map_, {gone}).poses.empty());
  EXPECT_TRUE(AdjustGlobally(map_, {}).points.empty());
}

TEST_F(MapBundleTest, PartsOfAMapLeaveTheRestAlone) {
  const std::vector<KeyframeId> some(keyframes_.begin() + 4, keyframes_.begin() + 7);
  const GlobalBundle bundle = AdjustGlobally(map_, some);
  EXPECT_EQ(bundle.poses.size(), 2u);  // without the first keyframe, the oldest is held
  for (const auto& [id, pose] : bundle.poses) EXPECT_LT(some.front(), id);
  EXPECT_EQ(bundle.points.size(), map_.SeenBy(some).size());
}

TEST_F(MapBundleTest, LocallyTheKeyframesAroundHoldTheRest) {
  LocalBundleOptions options;
  options.max_moving = 3;
  for (int k = 0; k < kKeyframes; ++k) map_.SetPose(keyframes_[static_cast<size_t>(k)], truth_[static_cast<size_t>(k)]);
  const KeyframeId center = keyframes_[5];
  map_.SetPose(center, Rigid3::FromStep(Eigen::Matrix<double, 6, 1>::Constant(0.01)) * truth_[5]);
  const LocalBundle bundle = AdjustLocally(map_, center, options, {});
  EXPECT_EQ(bundle.poses.size(), 3u);
  for (const auto& [id, pose] : bundle.poses) EXPECT_LT(Error(id, pose), 1e-4);
}

TEST_F(MapBundleTest, ViewsThatDoNotFitAreNamed) {
  // A keypoint of the last keyframe is said to see a landmark that is elsewhere.
  const Keyframe& last = *map_.Find(keyframes_.back());
  std::vector<uint32_t> seeing;
  for (uint32_t i = 0; i < last.landmarks.size() && seeing.size() < 2; ++i) {
    if (last.landmarks[i].IsValid() && map_.Find(last.landmarks[i])->views.size() > 4) seeing.push_back(i);
  }
  ASSERT_EQ(seeing.size(), 2u);
  const LandmarkId a = last.landmarks[seeing[0]], b = last.landmarks[seeing[1]];
  map_.Unobserve(a, keyframes_.back());
  map_.Unobserve(b, keyframes_.back());
  ASSERT_TRUE(map_.Observe(a, keyframes_.back(), seeing[1]));
  const GlobalBundle bundle = AdjustGlobally(map_, keyframes_);
  ASSERT_EQ(bundle.outliers.size(), 1u);
  EXPECT_EQ(bundle.outliers[0], std::make_pair(a, keyframes_.back()));
  for (const auto& [id, pose] : bundle.poses) EXPECT_LT(Error(id, pose), 1e-3);
}

TEST_F(MapBundleTest, StopsWhenTold) {
  const GlobalBundle bundle = AdjustGlobally(map_, keyframes_, {}, [] { return true; });
  EXPECT_TRUE(bundle.was_stopped);
  EXPECT_EQ(bundle.final_cost, bundle.initial_cost);
}

TEST_F(MapBundleTest, ATieHoldsAKeyframeWhoseLandmarksNobodyElseSees) {
  const KeyframeId last = keyframes_.back(), other = keyframes_[kKeyframes - 2];
  LeaveAlone(last);
  map_.SetTie(last, {other, truth_.back() * truth_[kKeyframes - 2].Inverse(), 1e6 * Matrix6d::Identity()});
  ASSERT_EQ(map_.Check(), "");
  const auto adjusted = AdjustedAround(last);
  ASSERT_TRUE(adjusted);
  const Rigid3 wanted = map_.Find(last)->tie->cam_from_other * map_.Find(other)->cam_from_world;
  EXPECT_LT((adjusted->OriginInSource() - wanted.OriginInSource()).norm(), 1e-4) << "it goes with the other";
}

TEST_F(MapBundleTest, ATieOutlivesTheKeyframeAtItsOtherEnd) {
  const KeyframeId last = keyframes_.back(), other = keyframes_[kKeyframes - 2], above = keyframes_[kKeyframes - 3];
  LeaveAlone(last);
  const Rigid3 last_from_other = truth_.back() * truth_[kKeyframes - 2].Inverse();
  const Rigid3 other_from_above = map_.Find(other)->cam_from_world * map_.Find(above)->cam_from_world.Inverse();
  map_.SetTie(last, {other, last_from_other, 1e6 * Matrix6d::Identity()});
  map_.Remove(other);
  ASSERT_EQ(map_.Surviving(other), above);
  const auto adjusted = AdjustedAround(last);
  ASSERT_TRUE(adjusted);
  const Rigid3 wanted = last_from_other * other_from_above * map_.Find(above)->cam_from_world;
  EXPECT_LT((adjusted->OriginInSource() - wanted.OriginInSource()).norm(), 1e-4);
}

/// The last keyframe, whose landmarks nobody else sees, is tilted; straight edges of the room say how it stands.
TEST_F(MapBundleTest, StraightEdgesRightAKeyframe) {
  Random random(2);
  const auto turn_left = [&](bool has_lines) {
    for (size_t k = 0; k < keyframes_.size(); ++k) {
      map_.SetPose(keyframes_[k], truth_[k]);
      map_.SetLines(keyframes_[k], has_lines ? LinesOfARoom(truth_[k].rotation, 20, random) : nullptr);
    }
    const Rigid3 tilted = Rigid3(RotationFromVector({0.03, 0, -0.03}), Eigen::Vector3d::Zero()) * truth_.back();
    map_.SetPose(keyframes_.back(), tilted);
    const auto adjusted = AdjustedAround(keyframes_.back());
    return (adjusted.value_or(tilted) * truth_.back().Inverse()).RotationAngle();
  };
  LeaveAlone(keyframes_.back());
  const Rigid3 step = truth_.back() * truth_[kKeyframes - 2].Inverse();
  Matrix6d place_only = Matrix6d::Zero();
  place_only.bottomRightCorner<3, 3>() = 1e6 * Eigen::Matrix3d::Identity();
  map_.SetTie(keyframes_.back(), {keyframes_[kKeyframes - 2], step, place_only});
  EXPECT_GT(turn_left(false), 0.03);
  EXPECT_LT(turn_left(true), 0.003);
}

}  // namespace
}  // namespace yorb

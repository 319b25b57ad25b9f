// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Tracker and mapper together on frames with exact truth: what no single room can promise.
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "map/synthetic_world.h"
#include "mapping/mapper.h"
#include "motion/test_scene.h"
#include "tracking/tracker.h"

namespace yorb {
namespace {

/// A hand that moves the camera to and fro, 30 frames a second.
Rigid3 PoseAt(int frame) {
  const double t = frame / 30.0;
  return {RotationFromVector({0.1 * std::sin(t), 0.3 * std::sin(0.7 * t), 0.05 * std::sin(1.3 * t)}),
          Eigen::Vector3d(0.5 * std::sin(t), 0.2 * std::sin(1.7 * t), 0.3 * std::cos(t) - 0.3)};
}

Timestamp TimeOf(int frame) { return {frame * int64_t{33000000}}; }

/// The river without pictures and threads.
class River {
 public:
  River() : tracker_(TrackingOptions(), 1), mapper_(MappingOptions()), map_(mapper_.Snapshot()) {}

  FrameRecord Push(const FramePtr& frame, Sight sight = {}) {
    Tracked tracked = tracker_.Track(frame, *map_, 0, std::move(sight));
    if (tracked.proposal) {
      mapper_.Handle(*tracked.proposal, {});
      map_ = mapper_.Snapshot();
    }
    return tracked.record;
  }
  Rigid3 PoseOf(const FrameRecord& record) const {
    return record.cam_from_reference * *map_->CamFromWorld(record.reference);
  }
  const Map& map() const { return *map_; }

  /// As if a bundle had found the newest keyframe elsewhere, with what it alone sees.
  void ShiftNewestKeyframe(const Eigen::Vector3d& shift) {
    const Keyframe& newest = *map_->Find(map_->newest_keyframe());
    Correction correction;
    correction.poses.emplace_back(newest.id, newest.cam_from_world * Rigid3(Eigen::Quaterniond::Identity(), -shift));
    for (const LandmarkId id : newest.landmarks) {
      const Landmark* landmark = id.IsValid() ? map_->Find(id) : nullptr;
      if (landmark) correction.points.emplace_back(id, landmark->position + shift);
    }
    mapper_.Apply(correction);
    map_ = mapper_.Snapshot();
  }

 private:
  Tracker tracker_;
  Mapper mapper_;
  MapSnapshot map_;
};

SyntheticWorldOptions Noisy() {
  SyntheticWorldOptions options;
  options.pixel_noise = 0.5;
  options.depth_noise = 0.5;
  options.depth_share = 0.7;
  return options;
}

double ErrorM(const Rigid3& cam_from_world, int frame) {
  const Rigid3 truth = PoseAt(frame) * PoseAt(0).Inverse();  // the first frame defines the world
  return (cam_from_world.OriginInSource() - truth.OriginInSource()).norm();
}

TEST(River, FollowsTheCameraToTheCentimetre) {
  const SyntheticWorld world(11, Noisy());
  River river;
  double sum = 0;
  for (int k = 0; k < 240; ++k) {
    const FrameRecord record = river.Push(world.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame);
    ASSERT_EQ(record.state, TrackingState::kTracking) << k;
    const double error = ErrorM(river.PoseOf(record), k);
    ASSERT_LT(error, 0.03) << k;
    sum += error * error;
    if (record.is_keyframe) {
      ASSERT_EQ(river.map().Check(), "") << k;
    }
  }
  EXPECT_LT(std::sqrt(sum / 240), 0.01);
  EXPECT_LT(river.map().num_keyframes(), 60u);
}

TEST(River, SaysThatItIsLostAndFindsItselfAgain) {
  const SyntheticWorld world(12, Noisy());
  const SyntheticWorld dark(13, [] {
    SyntheticWorldOptions options;
    options.num_points = 0;
    return options;
  }());
  River river;
  TrackingState state = TrackingState::kNotInitialized;
  for (int k = 0; k < 60; ++k)
    state = river.Push(world.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame).state;
  ASSERT_EQ(state, TrackingState::kTracking);
  for (int k = 60; k < 120; ++k) {
    state = river.Push(dark.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame).state;
    EXPECT_EQ(state, k < 75 ? TrackingState::kRecentlyLost : TrackingState::kLost) << k;
  }
  // The camera comes back to where it was, not to where it would be by now.
  FrameRecord record;
  for (int k = 120; k < 125; ++k) {
    record = river.Push(world.Look(PoseAt(k - 80), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame);
    ASSERT_EQ(record.state, TrackingState::kTracking) << k;
    EXPECT_LT(ErrorM(river.PoseOf(record), k - 80), 0.03);
  }
}

TEST(River, NeverPlacesACameraInAnotherWorld) {
  const SyntheticWorld world(14, Noisy()), elsewhere(15, Noisy());
  River river;
  for (int k = 0; k < 30; ++k) river.Push(world.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame);
  for (int k = 30; k < 60; ++k) {
    const FrameRecord record =
        river.Push(elsewhere.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame);
    EXPECT_NE(record.state, TrackingState::kTracking) << k;
  }
}

TEST(River, GivesARepeatedPictureThePoseOfTheFirst) {
  const SyntheticWorld world(17, Noisy());
  River river;
  FrameRecord record;
  for (int k = 0; k < 20; ++k) {
    record = river.Push(world.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame);
  }
  const Rigid3 pose = river.PoseOf(record);
  const size_t num_keyframes = river.map().num_keyframes();
  const FramePtr frozen = world.Look(PoseAt(19), FrameId(19), TimeOf(19)).frame;
  for (int k = 20; k < 80; ++k) {
    auto repeat = std::make_shared<Frame>(*frozen);
    repeat->id = FrameId(static_cast<uint32_t>(k));
    repeat->timestamp = TimeOf(k);
    record = river.Push(repeat);
    ASSERT_EQ(record.state, TrackingState::kTracking);
    EXPECT_EQ(river.PoseOf(record).translation, pose.translation);
  }
  EXPECT_EQ(river.map().num_keyframes(), num_keyframes);
  record = river.Push(world.Look(PoseAt(21), FrameId(80), TimeOf(80)).frame);
  EXPECT_EQ(record.state, TrackingState::kTracking);
  EXPECT_LT(ErrorM(river.PoseOf(record), 21), 0.03);
}

TEST(River, KnowsARepeatedPictureByItsPixelsWhereOtherPointsAreLeftOutOfIt) {
  const SyntheticWorld world(17, Noisy());
  River river;
  Sight sight;
  sight.grey = cv::Mat(480, 640, CV_8UC1, cv::Scalar(7));
  FrameRecord record;
  for (int k = 0; k < 20; ++k) {
    const FramePtr frame = world.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame;
    record = river.Push(frame, k == 19 ? sight : Sight());
  }
  const Rigid3 pose = river.PoseOf(record);
  const FramePtr frozen = world.Look(PoseAt(19), FrameId(20), TimeOf(20)).frame;
  std::vector<bool> left_out(frozen->size(), false);
  std::fill(left_out.begin(), left_out.begin() + static_cast<std::ptrdiff_t>(left_out.size() / 3), true);
  const FramePtr fewer = WithoutRows(frozen, left_out);
  EXPECT_EQ(river.PoseOf(river.Push(fewer, sight)).translation, pose.translation);
  sight.grey = sight.grey.clone();
  sight.grey.at<uint8_t>(479, 639) = 8;
  EXPECT_NE(river.PoseOf(river.Push(fewer, sight)).translation, pose.translation) << "one pixel differs";
}

TEST(River, WaitsForAFrameWithDepthToBegin) {
  SyntheticWorldOptions flat = Noisy();
  flat.depth_share = 0;
  const SyntheticWorld world(16, Noisy()), blind(16, flat);
  River river;
  for (int k = 0; k < 5; ++k) {
    const FrameRecord record = river.Push(blind.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame);
    EXPECT_EQ(record.state, TrackingState::kNotInitialized);
    EXPECT_FALSE(record.is_keyframe);
  }
  const FrameRecord record = river.Push(world.Look(PoseAt(5), FrameId(5), TimeOf(5)).frame);
  EXPECT_EQ(record.state, TrackingState::kTracking);
  EXPECT_TRUE(record.is_keyframe);
  // From then on depth may be gone.
  for (int k = 6; k < 20; ++k) {
    EXPECT_EQ(river.Push(blind.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame).state,
              TrackingState::kTracking);
  }
}

TEST(River, GoesOnFromWhereTheMapperPutTheFrameBefore) {
  const SyntheticWorld world(18, Noisy());
  River river;
  int k = 0;
  const auto push = [&] {
    const FrameRecord record = river.Push(world.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame);
    ++k;
    return record;
  };
  push();
  while (!push().is_keyframe) ASSERT_LT(k, 200);
  const Eigen::Vector3d shift(0.3, 0.1, -0.2);
  river.ShiftNewestKeyframe(shift);
  const FrameRecord record = push();
  ASSERT_EQ(record.state, TrackingState::kTracking);
  const Rigid3 truth = PoseAt(k - 1) * PoseAt(0).Inverse();
  EXPECT_LT((river.PoseOf(record).OriginInSource() - truth.OriginInSource() - shift).norm(), 0.03);
}

TEST(River, WallsCarryOnForSomeFramesWithoutAPoint) {
  // The walls of the room of the synthetic world.
  const std::vector<TestBox> walls = {{{-3.2, -1.5, -4}, {-3, 1.5, 2}},
                                      {{3, -1.5, -4}, {3.2, 1.5, 2}},
                                      {{-3, -1.7, -4}, {3, -1.5, 2}},
                                      {{-3, 1.5, -4}, {3, 1.7, 2}},
                                      {{-3, -1.5, 2}, {3, 1.5, 2.2}}};
  const SyntheticWorld world(19, Noisy()), dark(13, [] {
    SyntheticWorldOptions options;
    options.num_points = 0;
    return options;
  }());
  Random random(1);
  const DepthGridMaker maker(world.rig());
  River river;
  for (int k = 0; k < 26; ++k) {
    const bool is_dark = k >= 8 && k < 13, is_long_dark = k >= 16 && k < 22;
    const SyntheticWorld& seen = is_dark || is_long_dark ? dark : world;
    const DepthGrid grid = maker.Make(LookAtBoxes(world.rig(), PoseAt(k), walls, random).depth);
    const FrameRecord record =
        river.Push(seen.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame, {grid, {}});
    if (k == 21) {
      EXPECT_NE(record.state, TrackingState::kTracking) << "not for long";
      continue;
    }
    ASSERT_EQ(record.state, TrackingState::kTracking) << k;
    EXPECT_LT(ErrorM(river.PoseOf(record), k), 0.03) << k;
    if (is_dark) {
      EXPECT_EQ(record.num_inliers, 0);
      EXPECT_FALSE(record.is_keyframe);
    }
  }
}

TEST(River, MotionCarriesOnForThreeFramesWherePeopleHideAll) {
  const SyntheticWorld world(19, Noisy()), dark(13, [] {
    SyntheticWorldOptions options;
    options.num_points = 0;
    return options;
  }());
  River river;
  for (int k = 0; k < 26; ++k) {
    const bool is_hidden = k == 8 || (k >= 12 && k < 16), is_dark = k == 22;
    const SyntheticWorld& seen = is_hidden || is_dark ? dark : world;
    const FrameRecord record = river.Push(seen.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame,
                                          {{}, {}, {}, is_hidden ? 0.8 : 0.1});
    if (k == 15 || is_dark) {
      EXPECT_NE(record.state, TrackingState::kTracking) << "not for long, and never where nothing hides the view";
      continue;
    }
    ASSERT_EQ(record.state, TrackingState::kTracking) << k;
    EXPECT_LT(ErrorM(river.PoseOf(record), k), 0.03) << k;
    if (!is_hidden) continue;
    EXPECT_EQ(record.num_inliers, 0);
    EXPECT_FALSE(record.is_keyframe);
  }
}

TEST(River, AfterFramesWithoutAPointAFewProveNothing) {
  const SyntheticWorld world(19, Noisy());
  const auto few_of = [](const FramePtr& frame) {
    constexpr size_t kFew = 24;
    std::vector<bool> left_out(frame->size());
    for (size_t i = 0; i < left_out.size(); ++i) left_out[i] = i % (frame->size() / kFew) != 0;
    return WithoutRows(frame, left_out);
  };
  for (const bool was_hidden : {false, true}) {
    River river;
    FrameRecord record;
    for (int k = 0; k < 12; ++k) {
      FramePtr frame = world.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k)).frame;
      if (k == 10 && was_hidden) frame = WithoutRows(frame, std::vector<bool>(frame->size(), true));
      record = river.Push(k == 11 ? few_of(frame) : frame, {{}, {}, {}, k >= 10 ? 0.8 : 0.1});
    }
    EXPECT_EQ(record.state, TrackingState::kTracking);
    EXPECT_EQ(record.num_inliers > 0, !was_hidden);
  }
}

/// A picture in which every point is a speckled patch of its own.
cv::Mat Draw(const SyntheticWorld::View& view, const Rig& rig) {
  constexpr int kSide = 9;
  cv::Mat picture(rig.camera.height, rig.camera.width, CV_8UC1, cv::Scalar(128));
  for (size_t i = 0; i < view.points.size(); ++i) {
    cv::Mat patch(kSide, kSide, CV_8UC1);
    cv::RNG(view.points[i] + 1).fill(patch, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(patch, patch, {}, 1);
    const Keypoint& point = view.frame->keypoints[i];
    const cv::Rect at(cvRound(point.x) - kSide / 2, cvRound(point.y) - kSide / 2, kSide, kSide);
    if ((at & cv::Rect({}, picture.size())) == at) patch.copyTo(picture(at));
  }
  return picture;
}

/// The frame as blur leaves it: its descriptors say nothing.
FramePtr Scrambled(const Frame& frame) {
  auto scrambled = std::make_shared<Frame>(frame);
  Random random(5);
  for (Descriptor& descriptor : scrambled->descriptors) {
    for (uint64_t& word : descriptor) word = random.Next();
  }
  return scrambled;
}

TEST(River, OpticalFlowCarriesOnWhereDescriptorsSayNothing) {
  const SyntheticWorld world(23, Noisy());
  for (const bool has_pictures : {true, false}) {
    River river;
    for (int k = 0; k < 16; ++k) {
      const auto view = world.Look(PoseAt(k), FrameId(static_cast<uint32_t>(k)), TimeOf(k));
      const bool is_blurred = k == 12;
      const FramePtr frame = is_blurred ? Scrambled(*view.frame) : view.frame;
      const FrameRecord record = river.Push(frame, {{}, has_pictures ? Draw(view, world.rig()) : cv::Mat()});
      if (is_blurred && !has_pictures) {
        EXPECT_NE(record.state, TrackingState::kTracking) << "or this test shows nothing";
        continue;
      }
      ASSERT_EQ(record.state, TrackingState::kTracking) << k;
      EXPECT_LT(ErrorM(river.PoseOf(record), k), 0.02) << k;
    }
  }
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/sequence.h"

#include <gtest/gtest.h>

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/parallel.h"

namespace yorb {
namespace {

SequenceOptions SmallSequence(PathKind path, int num_people, double noise) {
  SequenceOptions options;
  options.path = path;
  options.num_frames = 60;
  options.num_people = num_people;
  options.noise = noise;
  options.room.texture_size = 256;
  options.room.has_shadows = false;
  options.rig = SyntheticRig(320, 240);
  return options;
}

struct Agreement {
  int num_seen = 0, num_deep = 0;  // points of A that fall into B; those with the depth that B has there
  double mean_grey_difference = 0;
};

// Carries A's pixels through the true poses into B.
Agreement Compare(const RenderedFrame& a, const RenderedFrame& b, const Pinhole& camera) {
  const Rigid3 b_from_a = b.world_from_cam.Inverse() * a.world_from_cam;
  Agreement agreement;
  double difference = 0;
  for (int y = 0; y < camera.height; y += 2) {
    for (int x = 0; x < camera.width; x += 2) {
      if (a.mask.at<uchar>(y, x) != 0) continue;
      const Eigen::Vector3d x_in_b = b_from_a * camera.Unproject(x, y, a.images.depth.At(x, y));
      const Eigen::Vector2d at = camera.Project(x_in_b);
      const int column = static_cast<int>(std::lround(at.x())), row = static_cast<int>(std::lround(at.y()));
      if (x_in_b.z() <= 0 || column < 0 || row < 0 || column >= camera.width || row >= camera.height) continue;
      ++agreement.num_seen;
      if (std::abs(b.images.depth.At(column, row) - x_in_b.z()) > 0.01 * x_in_b.z() ||
          b.mask.at<uchar>(row, column) != 0)
        continue;
      ++agreement.num_deep;
      difference += std::abs(a.images.grey.at<uchar>(y, x) - b.images.grey.at<uchar>(row, column));
    }
  }
  agreement.mean_grey_difference = difference / agreement.num_deep;
  return agreement;
}

TEST(SyntheticSequence, DepthAndColourAgreeWithTheTruePoses) {
  for (const PathKind path : {PathKind::kHalfsphere, PathKind::kRpy}) {
    const SyntheticSequence sequence(SmallSequence(path, 1, 0));
    const Agreement same = Compare(sequence.Render(20), sequence.Render(32), sequence.rig().camera);
    EXPECT_GT(same.num_seen, 12000);
    EXPECT_GT(same.num_deep, 0.9 * same.num_seen);  // the rest is hidden in one of the two, or at an edge
    EXPECT_LT(same.mean_grey_difference, 9);
    // With poses that are a little wrong they do not agree: the check above can fail.
    RenderedFrame wrong = sequence.Render(32);
    wrong.world_from_cam = wrong.world_from_cam * Rigid3(RotationFromVector({0, 0.02, 0}), {0, 0, 0.03});
    const Agreement off = Compare(sequence.Render(20), wrong, sequence.rig().camera);
    EXPECT_LT(off.num_deep, 0.8 * off.num_seen);
    EXPECT_GT(off.mean_grey_difference, 1.3 * same.mean_grey_difference);
  }
}

TEST(SyntheticSequence, OrbFindsTheSamePointsAgain) {
  const SyntheticSequence sequence(SmallSequence(PathKind::kXyz, 0, 1));
  const RenderedFrame a = sequence.Render(20), b = sequence.Render(26);
  const auto orb = cv::ORB::create(500);
  std::vector<cv::KeyPoint> points_a, points_b;
  cv::Mat descriptors_a, descriptors_b;
  orb->detectAndCompute(a.images.grey, cv::noArray(), points_a, descriptors_a);
  orb->detectAndCompute(b.images.grey, cv::noArray(), points_b, descriptors_b);
  ASSERT_GT(points_a.size(), 450u);
  std::vector<cv::DMatch> matches;
  cv::BFMatcher(cv::NORM_HAMMING, true).match(descriptors_a, descriptors_b, matches);
  const Pinhole& camera = sequence.rig().camera;
  const Rigid3 b_from_a = b.world_from_cam.Inverse() * a.world_from_cam;
  size_t num_right = 0;
  for (const cv::DMatch& match : matches) {
    const cv::Point2f from = points_a[match.queryIdx].pt, to = points_b[match.trainIdx].pt;
    const double depth = a.exact_depth.at<float>(static_cast<int>(from.y), static_cast<int>(from.x));
    const Eigen::Vector2d expected = camera.Project(b_from_a * camera.Unproject(from.x, from.y, depth));
    num_right += (expected - Eigen::Vector2d(to.x, to.y)).norm() < 3;
  }
  EXPECT_GT(num_right, points_a.size() / 2);
}

TEST(SyntheticSequence, AFrameDependsOnItsOptionsAndNumberAlone) {
  SequenceOptions options = SmallSequence(PathKind::kLoop, 2, 1);
  options.room.has_shadows = true;
  options.room.texture_size = 64;
  const SyntheticSequence one(options);
  options.room.num_threads = 3;
  const SyntheticSequence other(options);
  std::vector<RenderedFrame> frames(6);
  ParallelFor(frames.size(), 3, [&](size_t i) { frames[i] = other.Render(static_cast<int>(50 - 10 * i)); });
  for (size_t i = 0; i < frames.size(); ++i) {
    const RenderedFrame frame = one.Render(static_cast<int>(50 - 10 * i));
    EXPECT_EQ(cv::norm(frame.images.colour, frames[i].images.colour), 0);
    EXPECT_EQ(cv::norm(frame.images.depth.pixels, frames[i].images.depth.pixels), 0);
    EXPECT_EQ(cv::norm(frame.mask, frames[i].mask), 0);
  }
  options.seed = 2;
  EXPECT_GT(cv::norm(SyntheticSequence(options).Render(0).images.colour, one.Render(0).images.colour, cv::NORM_L1),
            1e5);
}

TEST(SyntheticSequence, BoxesHoldWhatIsVisibleOfPeople) {
  const SyntheticSequence sequence(SmallSequence(PathKind::kStatic, 3, 0));
  size_t num_boxes = 0;
  for (int frame = 0; frame < 60; frame += 6) {
    const RenderedFrame rendered = sequence.Render(frame);
    num_boxes += rendered.boxes.size();
    for (const PersonBox& box : rendered.boxes) {
      const cv::Mat person = rendered.mask == box.person;
      EXPECT_EQ(cv::boundingRect(person), cv::Rect(box.left, box.top, box.right - box.left, box.bottom - box.top));
      EXPECT_EQ(cv::countNonZero(person), box.num_visible_px);
      EXPECT_GE(box.num_visible_px, kMinVisiblePx);
    }
  }
  EXPECT_GT(num_boxes, 5u);
}

TEST(SyntheticSequence, PeopleStandOnTheFloorAtTheirHeight) {
  RoomOptions small;
  small.texture_size = 64;
  small.has_shadows = false;
  Room room = MakeRoom(small);
  for (const double speed : {1.0, -1.0, 0.0}) {
    const Mannequin person({1, 0, speed, 1.8}, room.stage.routes[1], 1, 3, room.scene);
    for (double t = 0; t < 3; t += 0.11) {
      MovingThings moving;
      person.AddTo(moving, room.scene, t);
      Eigen::AlignedBox3f box;
      for (const Patch& patch : moving.patches)
        box.extend(patch.corner), box.extend(patch.At(1, 0)), box.extend(patch.At(0, 1));
      EXPECT_NEAR(box.min().z(), 0, 0.06);
      EXPECT_NEAR(box.max().z(), 1.8, 0.1);
      EXPECT_LT(box.sizes().head<2>().maxCoeff(), 1.3);
      EXPECT_LT((box.center().head<2>() - moving.shadows.at(0).centre).norm(), 0.35);
    }
  }
}

TEST(SyntheticSequence, TruthHasOnePoseAFrameAtItsStamp) {
  const SyntheticSequence sequence(SmallSequence(PathKind::kXyz, 0, 0));
  const Trajectory truth = sequence.Truth();
  ASSERT_EQ(truth.size(), 60u);
  EXPECT_EQ(truth[7].timestamp, sequence.Render(7).images.timestamp);
  EXPECT_EQ(truth[7].world_from_cam.translation, sequence.Render(7).world_from_cam.translation);
  EXPECT_NEAR(SecondsBetween(truth[0].timestamp, truth[30].timestamp), 1, 1e-9);
}

TEST(CheckOptions, RefusesWhatCannotBeRendered) {
  const SequenceOptions good = SmallSequence(PathKind::kXyz, 0, 0);
  EXPECT_TRUE(CheckOptions(good).ok());
  SequenceOptions bad = good;
  bad.num_frames = 0;
  EXPECT_FALSE(CheckOptions(bad).ok());
  bad = good;
  bad.num_people = kMaxPeople + 1;
  EXPECT_FALSE(CheckOptions(bad).ok());
  bad = good;
  bad.noise = std::nan("");
  EXPECT_FALSE(CheckOptions(bad).ok());
  bad = good;
  bad.rig.camera.distortion = {5, 5, 1, 1, 0, 0, 0, 0};
  EXPECT_FALSE(CheckOptions(bad).ok());
  bad = good;
  bad.rig.camera.width = 0;
  EXPECT_FALSE(CheckOptions(bad).ok());
}

}  // namespace
}  // namespace yorb

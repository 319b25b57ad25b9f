// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/moved_points.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/random.h"
#include "map/synthetic_world.h"

namespace yorb {
namespace {

using ShiftOf = std::function<Eigen::Vector3d(size_t)>;

/// Two frames of one wall, a fifth of a second apart. `thing` are keypoints that no landmark explains: in the first
/// frame they were elsewhere, by the shift of each.
struct Pair {
  Pair(size_t num_thing, const ShiftOf& shift_of) {
    SyntheticWorldOptions options;
    options.num_points = 20000;
    options.pixel_noise = 0.5;
    options.depth_noise = 0.5;
    const SyntheticWorld world(1, options);
    const Rigid3 pose(RotationFromVector({0, 0.02, 0}), {0.03, 0, 0});
    now.frame = world.Look(pose, FrameId(1), Timestamp{200000000}).frame;
    const auto before = world.Look(Rigid3::Identity(), FrameId(0), Timestamp{0});
    const auto after = world.Look(pose, FrameId(1), Timestamp{200000000});
    now_from_then = pose;
    now.is_known.assign(now.frame->size(), true);
    auto frame = std::make_shared<Frame>(*before.frame);
    then.is_known.assign(frame->size(), true);
    for (size_t i = 0; i < frame->size() && thing.size() < num_thing; ++i) {
      const auto same = std::find(after.points.begin(), after.points.end(), before.points[i]);
      const bool is_in_it = (frame->points_px[i] - Eigen::Vector2f(300, 200)).norm() < 45;
      if (!is_in_it || same == after.points.end()) continue;
      const Eigen::Vector3d x_in_cam = frame->PointInCam(i) - shift_of(thing.size());
      frame->points_px[i] = frame->rig->camera.Project(x_in_cam).cast<float>();
      frame->depth[i] = static_cast<float>(x_in_cam.z());
      then.is_known[i] = false;
      thing.push_back(static_cast<uint32_t>(same - after.points.begin()));
      now.is_known[thing.back()] = false;
    }
    // Around the thing nothing else is known, as on somebody who hides the wall.
    for (size_t i = 0; i < now.frame->size(); ++i) {
      if ((now.frame->points_px[i] - now.frame->points_px[thing[0]]).norm() < 160) now.is_known[i] = false;
    }
    frame->grid = Grid(frame->bounds, frame->points_px);
    then.frame = frame;
  }
  std::vector<uint32_t> Find() const { return FindMovedPoints(then, now, now_from_then); }

  PosedFrame then, now;
  Rigid3 now_from_then;
  std::vector<uint32_t> thing;
};

TEST(FindMovedPoints, FindsAThingThatWentAndNothingElse) {
  const Pair pair(20, [](size_t) { return Eigen::Vector3d(0.15, 0, 0); });
  ASSERT_EQ(pair.thing.size(), 20u);
  const auto found = pair.Find();
  EXPECT_GT(found.size(), 14u);
  for (const uint32_t index : found) EXPECT_EQ(std::count(pair.thing.begin(), pair.thing.end(), index), 1);
}

TEST(FindMovedPoints, TakesNoNoiseForMotion) {
  EXPECT_TRUE(Pair(20, [](size_t) { return Eigen::Vector3d::Zero(); }).Find().empty());
}

TEST(FindMovedPoints, TakesOneOutlierForNoMover) {
  EXPECT_TRUE(Pair(3, [](size_t) { return Eigen::Vector3d(0.15, 0, 0); }).Find().empty());
}

TEST(FindMovedPoints, TakesNoWaysInAllDirectionsForAThing) {
  const auto scatter = [](size_t i) {
    return RotationFromVector({0, 0, static_cast<double>(i) * 2.4}) * Eigen::Vector3d(0.15, 0, 0);
  };
  EXPECT_TRUE(Pair(20, scatter).Find().empty());
}

}  // namespace
}  // namespace yorb

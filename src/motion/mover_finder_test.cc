// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/mover_finder.h"

#include <gtest/gtest.h>

#include <functional>

#include "motion/test_scene.h"

namespace yorb {
namespace {

constexpr uint8_t kThing = 4;  // of the boxes in Room

/// A wall, a floor and a pillar that stand still, and one thing more.
std::vector<TestBox> Room(double thing_x) {
  return {{{-9, -9, 3.5}, {9, 9, 3.6}},
          {{-9, 1.2, -9}, {9, 1.3, 9}},
          {{-1.3, -0.6, 2}, {-0.9, 1.2, 2.3}},
          {{thing_x - 0.25, -0.3, 2}, {thing_x + 0.25, 0.5, 2.3}}};
}

/// A hand-held camera that sways.
Rigid3 CameraAt(double seconds) {
  const double turn = 0.1 * std::sin(2 * seconds);
  return {RotationFromVector({0.03 * std::sin(3 * seconds), turn, 0}),
          {0.25 * std::sin(1.5 * seconds), 0.05 * std::sin(2.5 * seconds), 0.1 * std::cos(seconds)}};
}

/// A frame without points.
PosedFrame Posed(const Rig& rig, double seconds, const Rigid3& pose) {
  auto frame = std::make_shared<Frame>();
  frame->timestamp = Timestamp{static_cast<int64_t>(seconds * 1e9)};
  frame->rig = std::make_shared<const Rig>(rig);
  return {frame, {}, {KeyframeId(0), pose}};
}

/// How the cells were judged, by what the middle of each shows.
struct Tally {
  int moving_of_thing = 0, all_of_thing = 0, moving_elsewhere = 0;
  double Recall() const { return all_of_thing > 0 ? static_cast<double>(moving_of_thing) / all_of_thing : 0; }
};

/// Plays a room in which the thing is at `thing_x(seconds)`, ten pictures a second, and counts the last seconds.
class Playing {
 public:
  explicit Playing(std::function<double(double)> thing_x) : thing_x_(std::move(thing_x)) {}

  Tally Play(double from_s, double to_s) {
    Tally tally;
    for (; now_s_ < to_s; now_s_ += 0.1) {
      const Rigid3 pose = CameraAt(now_s_);
      const TestView view = LookAtBoxes(rig_, pose, Room(thing_x_(now_s_)), random_);
      const MovingCells moving = finder_.Find(Posed(rig_, now_s_, pose), grids_.Make(view.depth), map);
      if (now_s_ >= from_s) Count(view, moving, tally);
    }
    return tally;
  }

  Map map = MapWithOneKeyframe();

 private:
  void Count(const TestView& view, const MovingCells& moving, Tally& tally) const {
    for (int y = 4; y < view.box.rows; y += kGridCellPx) {
      for (int x = 4; x < view.box.cols; x += kGridCellPx) {
        const bool is_thing = view.box.at<uint8_t>(y, x) == kThing;
        const bool is_moving = moving.Has(static_cast<float>(x), static_cast<float>(y), view.depth.At(x, y));
        tally.all_of_thing += is_thing;
        (is_thing ? tally.moving_of_thing : tally.moving_elsewhere) += is_moving;
      }
    }
  }

  std::function<double(double)> thing_x_;
  Rig rig_ = DepthTestRig();
  DepthGridMaker grids_{rig_};
  MoverFinder finder_;
  Random random_{3};
  double now_s_ = 0;
};

TEST(MoverFinder, FindsAThingThatSlidesAndNothingElse) {
  Playing playing([](double s) { return -0.5 + 0.4 * s; });
  const Tally tally = playing.Play(1, 3);
  EXPECT_GT(tally.Recall(), 0.8);
  EXPECT_LE(tally.moving_elsewhere, tally.moving_of_thing / 50);
}

TEST(MoverFinder, FindsNothingWhereAllStandsStill) {
  Playing playing([](double) { return 0.3; });
  const Tally tally = playing.Play(0, 4);
  EXPECT_EQ(tally.moving_of_thing + tally.moving_elsewhere, 0);
}

TEST(MoverFinder, LetsAThingBeThatStandsStillAgain) {
  Playing playing([](double s) { return s < 1.5 ? -0.5 + 0.6 * s : 0.4; });
  EXPECT_GT(playing.Play(1, 1.5).Recall(), 0.7);
  const Tally tally = playing.Play(5.5, 6.5);
  EXPECT_EQ(tally.moving_of_thing + tally.moving_elsewhere, 0);
}

TEST(MoverFinder, IsNotMisledWhenTheMapIsCorrected) {
  Playing playing([](double) { return 0.3; });
  playing.Play(0, 1.5);
  playing.map.SetPose(KeyframeId(0), Rigid3(RotationFromVector({0.1, 0.3, 0}), {1, 2, 3}));
  const Tally tally = playing.Play(1.5, 2.5);
  EXPECT_EQ(tally.moving_of_thing + tally.moving_elsewhere, 0);
}

TEST(MoverFinder, WhatMovesIsNotMeasuredInAPictureWithoutMovers) {
  DepthGrid grid;
  grid.columns = 3, grid.rows = 1;
  grid.surface = grid.free = {1, 2, 3};
  const DepthGrid without = WithoutMovers(grid, {grid, {}, {0, 1, 0}});
  EXPECT_EQ(without.surface, (std::vector<float>{1, 0, 3}));
  EXPECT_EQ(without.free, (std::vector<float>{1, 0, 3}));
  EXPECT_EQ(WithoutMovers(grid, {}).surface, grid.surface) << "nothing moves";
}

TEST(MoverFinder, KnowsNothingOfBeforeOnceItForgets) {
  MoverFinder finder;
  const Rig rig = DepthTestRig();
  const DepthGridMaker grids(rig);
  const Map map = MapWithOneKeyframe();
  Random random(5);
  const auto look = [&](double seconds, double thing_x) {
    const TestView view = LookAtBoxes(rig, Rigid3::Identity(), Room(thing_x), random);
    return finder.Find(Posed(rig, seconds, Rigid3::Identity()), grids.Make(view.depth), map);
  };
  for (const double s : {0.0, 0.3, 0.6}) EXPECT_TRUE(look(s, -0.5).empty());
  EXPECT_FALSE(look(0.9, 0.5).empty());
  finder.Forget();
  EXPECT_TRUE(look(1.2, -0.5).empty());
  EXPECT_TRUE(finder.Find(Posed(rig, 2, Rigid3::Identity()), DepthGrid(), map).empty());
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/box_tracks.h"

#include <gtest/gtest.h>

namespace yorb {
namespace {

constexpr double kFrameS = 1.0 / 30;

Timestamp FrameTime(int i) { return {static_cast<int64_t>(i * kFrameS * 1e9)}; }

/// Someone who walks to the right by 5 px a frame.
Box Walker(int i) { return {"person", 0.9, 100.0 + 5 * i, 50, 180.0 + 5 * i, 300}; }

class BoxTracksTest : public testing::Test {
 protected:
  void See(int i, std::vector<Box> boxes) { Tell(i, {{true, std::move(boxes)}, FrameTime(i)}); }
  void Tell(int i, const SeenAt& looked) { tracks_.Update(FrameTime(i), looked, MotionTable::Default(), 640, 480); }
  size_t Count() { return tracks_.tracks().size(); }

  BoxTracks tracks_;
};

TEST_F(BoxTracksTest, WhatIsSeenIsThereAtOnce) {
  See(0, {Walker(0)});
  ASSERT_EQ(Count(), 1u);
  EXPECT_FALSE(tracks_.tracks()[0].IsBridged(FrameTime(0)));
}

TEST_F(BoxTracksTest, AMissedBoxMovesOnForAWhile) {
  for (int i = 0; i < 10; ++i) See(i, {Walker(i)});
  for (int i = 10; i < 18; ++i) See(i, {});
  ASSERT_EQ(Count(), 1u);
  EXPECT_TRUE(tracks_.tracks()[0].IsBridged(FrameTime(17)));
  EXPECT_NEAR(tracks_.tracks()[0].at.box.left, Walker(17).left, 6);
  for (int i = 18; i < 40; ++i) See(i, {});
  EXPECT_EQ(Count(), 0u);
}

TEST_F(BoxTracksTest, OfVeryManyTheSurestAreFollowed) {
  std::vector<Box> boxes;
  for (int i = 0; i < 1200; ++i) {  // small ones that do not touch
    const double x = 8 * (i % 80), y = 8 * (i / 80);
    boxes.push_back({"person", i < 200 ? 0.3 : 0.9, x, y, x + 6, y + 6});
    boxes.push_back({"table", 1, x, y, x + 6, y + 6});
  }
  See(0, boxes);
  See(1, boxes);
  ASSERT_EQ(Count(), 1000u);
  for (const BoxTrack& track : tracks_.tracks()) {
    ASSERT_EQ(track.at.box.confidence, 0.9);
    ASSERT_EQ(track.num_seen, 2);
  }
}

TEST_F(BoxTracksTest, WhoIsSaidToBeGoneIsNotBridged) {
  for (int i = 0; i < 10; ++i) See(i, {Walker(i)});
  Tell(10, {{true, {}, true}, FrameTime(10)});
  EXPECT_EQ(Count(), 0u);
}

TEST_F(BoxTracksTest, AFaintBoxContinuesButBeginsNothing) {
  BoxTracks tracks(0.25);
  const auto see = [&](int i, Box box, double confidence) {
    box.confidence = confidence;
    tracks.Update(FrameTime(i), {{true, {box}}, FrameTime(i)}, MotionTable::Default(), 640, 480);
    return tracks.tracks().size();
  };
  EXPECT_EQ(see(0, Walker(0), 0.1), 0u);
  EXPECT_EQ(see(1, Walker(1), 0.5), 1u);
  EXPECT_EQ(see(2, Walker(2), 0.1), 0u) << "seen surely but once";
  EXPECT_EQ(see(3, Walker(3), 0.5), 1u);
  EXPECT_EQ(see(4, Walker(4), 0.5), 1u);
  for (int i = 5; i < 40; ++i) ASSERT_EQ(see(i, Walker(i), 0.1), 1u);
  EXPECT_FALSE(tracks.tracks()[0].IsBridged(FrameTime(39)));
  EXPECT_NEAR(tracks.tracks()[0].at.box.left, Walker(39).left, 1);
  for (int i = 40; i < 80; ++i) see(i, Walker(i), 0.1);
  EXPECT_TRUE(tracks.tracks().empty()) << "nobody is sure of it for too long";
}

TEST_F(BoxTracksTest, PetsAreBelievedLessThanPeople) {
  for (const char* name : {"person", "cat"}) {
    BoxTracks tracks(0.25);
    Box box = Walker(0);
    box.name = name, box.confidence = 0.4;
    tracks.Update(FrameTime(0), {{true, {box}}, FrameTime(0)}, MotionTable::Default(), 640, 480);
    EXPECT_EQ(tracks.tracks().size(), box.name == "person" ? 1u : 0u);
    box.confidence = 0.6;
    tracks.Update(FrameTime(1), {{true, {box}}, FrameTime(1)}, MotionTable::Default(), 640, 480);
    EXPECT_EQ(tracks.tracks().size(), 1u);
  }
}

TEST_F(BoxTracksTest, OneFalseBoxIsGoneWithItsPicture) {
  See(0, {Walker(0)});
  See(1, {});
  EXPECT_EQ(Count(), 0u);
}

TEST_F(BoxTracksTest, NobodyWhoLooksIsNotNobodyThere) {
  See(0, {Walker(0)});
  See(1, {Walker(1)});
  for (int i = 2; i < 25; ++i) Tell(i, {{false, {}}, FrameTime(i)});
  EXPECT_EQ(Count(), 1u);
  for (int i = 25; i < 45; ++i) Tell(i, {{false, {}}, FrameTime(i)});
  EXPECT_EQ(Count(), 0u);
}

TEST_F(BoxTracksTest, WhatTheLastLookSawCountsAsSeenForAWhile) {
  for (int i = 0; i < 30; ++i) {
    Tell(i, {{i % 3 == 0, {Walker(i)}}, FrameTime(i)});
    ASSERT_EQ(Count(), 1u);
    EXPECT_FALSE(tracks_.tracks()[0].IsBridged(FrameTime(i)));
    if (i < 12) continue;
    EXPECT_NEAR(tracks_.tracks()[0].at.box.left, Walker(i).left, 2) << "moves on between looks";
  }
  EXPECT_EQ(tracks_.tracks()[0].num_seen, 10) << "looks, not pictures";
  for (int i = 30; i < 37; ++i) Tell(i, {{false, {}}, FrameTime(i)});
  EXPECT_TRUE(tracks_.tracks()[0].IsBridged(FrameTime(36)));
}

TEST_F(BoxTracksTest, WhatTheLastLookMissedStaysBridgedBetweenLooks) {
  for (int i = 0; i < 10; ++i) See(i, {Walker(i)});
  See(10, {});
  Tell(11, {{false, {}}, FrameTime(11)});
  ASSERT_EQ(Count(), 1u);
  EXPECT_TRUE(tracks_.tracks()[0].IsBridged(FrameTime(11)));
}

TEST_F(BoxTracksTest, ABoxThatComesLateIsMovedToNow) {
  for (int i = 0; i < 10; ++i) See(i, {Walker(i)});
  for (int i = 10; i < 20; ++i) Tell(i, {{true, {Walker(i - 3)}}, FrameTime(i - 3)});
  ASSERT_EQ(Count(), 1u) << "the same walker all the time";
  EXPECT_NEAR(tracks_.tracks()[0].at.box.left, Walker(19).left, 3);
}

TEST_F(BoxTracksTest, WhoLeavesThePictureIsGone) {
  for (int i = 0; i < 3; ++i) See(i, {{"person", 0.9, 600.0 + 15 * i, 0, 640, 480}});
  See(3, {}), See(4, {});
  EXPECT_EQ(Count(), 0u);
}

TEST_F(BoxTracksTest, StaticThingsAreNotFollowed) {
  See(0, {{"tv", 0.9, 10, 10, 100, 100}});
  EXPECT_EQ(Count(), 0u);
}

}  // namespace
}  // namespace yorb

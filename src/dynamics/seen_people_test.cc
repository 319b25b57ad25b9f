// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/seen_people.h"

#include <gtest/gtest.h>

#include "dynamics/test_depth.h"

namespace yorb {
namespace {

constexpr uint8_t kSure = 230, kHardly = 20;

/// A wall 3 m away, and things before it.
class SeenPeople : public testing::Test {
 protected:
  SeenPeople() : units_(kHeight, kWidth, CV_16UC1, Units(3)), people_(kHeight / 16, kWidth / 16, CV_8UC1, kHardly) {}

  static uint16_t Units(double metres) { return static_cast<uint16_t>(metres / kMetresPerUnit); }
  void Put(const cv::Rect& where, double metres) { units_(where).setTo(Units(metres)); }
  /// The network sees somebody there; whole cells of 16 px.
  void See(const cv::Rect& where) {
    people_(cv::Rect(where.x / 16, where.y / 16, where.width / 16, where.height / 16)).setTo(kSure);
  }

  DepthCells Depth() const { return DepthCells({units_, kMetresPerUnit}); }
  CellMask Known() const { return CellMask(static_cast<size_t>(Depth().columns() * Depth().rows()), 0); }

  /// How much of a rectangle is marked.
  double Share(const CellMask& mask, const cv::Rect& where) const {
    const DepthCells depth = Depth();
    int marked = 0, all = 0;
    for (int y = where.y + 2; y < where.y + where.height; y += kDepthCellPx) {
      for (int x = where.x + 2; x < where.x + where.width; x += kDepthCellPx) {
        marked += mask[depth.IndexOf(x / kDepthCellPx, y / kDepthCellPx)] == kBody, ++all;
      }
    }
    return static_cast<double>(marked) / all;
  }

  cv::Mat units_, people_;
  const cv::Rect person_{256, 96, 96, 320}, beside_{384, 96, 64, 320};
};

TEST_F(SeenPeople, AWholeThingIsSomebodyWhereTheMapSaysSoOfMostOfIt) {
  Put(person_, 1.5);
  See({256, 96, 96, 256});  // not the feet
  const CellMask mask = WithSeenPeople(Known(), Depth(), people_);
  EXPECT_EQ(Share(mask, person_), 1);
  EXPECT_EQ(Share(mask, beside_), 0);
}

TEST_F(SeenPeople, TheWallBesideSomebodyIsNotTakenForHim) {
  Put(person_, 1.5);
  See({224, 64, 256, 384});
  const CellMask mask = WithSeenPeople(Known(), Depth(), people_);
  EXPECT_EQ(Share(mask, person_), 1);
  EXPECT_EQ(Share(mask, beside_), 0);
}

TEST_F(SeenPeople, APosterIsPartOfItsWall) {
  See(person_);
  EXPECT_EQ(WithSeenPeople(Known(), Depth(), people_), Known());
}

TEST_F(SeenPeople, AThingThatTheMapDoesNotTakeForSomebodyStays) {
  Put(person_, 1.5);
  See({256, 96, 96, 128});  // little of it
  EXPECT_EQ(WithSeenPeople(Known(), Depth(), people_), Known());
}

TEST_F(SeenPeople, OneBehindAnotherIsAThingOfItsOwn) {
  Put(person_, 1.5);
  Put(beside_, 2.2);
  See({256, 96, 192, 320});
  CellMask known = Known();
  for (int y = person_.y; y < person_.y + person_.height; y += kDepthCellPx) {
    for (int x = person_.x; x < person_.x + person_.width; x += kDepthCellPx)
      known[Depth().IndexOf(x / kDepthCellPx, y / kDepthCellPx)] = kBody;
  }
  const CellMask mask = WithSeenPeople(known, Depth(), people_);
  EXPECT_EQ(Share(mask, person_), 1);
  EXPECT_EQ(Share(mask, beside_), 1);
}

TEST_F(SeenPeople, WhatIsKnownStaysAndTiesNothingTogether) {
  Put(person_, 1.5);
  See(person_);
  const CellMask lying(Known().size(), kLying);
  EXPECT_EQ(WithSeenPeople(lying, Depth(), people_), lying);
}

TEST_F(SeenPeople, CrumbsAndWhatIsNotMeasuredSayNothing) {
  units_.setTo(0);
  Put({256, 96, 8, 8}, 1.5);
  people_.setTo(kSure);
  EXPECT_EQ(WithSeenPeople(Known(), Depth(), people_), Known());
}

TEST_F(SeenPeople, WithoutAMapNothingIsMarked) {
  EXPECT_FALSE(ShowsSomebody({}));
  EXPECT_FALSE(ShowsSomebody(people_));
  EXPECT_EQ(WithSeenPeople(Known(), Depth(), {}), Known());
  See(person_);
  EXPECT_TRUE(ShowsSomebody(people_));
  EXPECT_TRUE(WithSeenPeople({}, DepthCells(DepthImage{}), people_).empty());
}

}  // namespace
}  // namespace yorb

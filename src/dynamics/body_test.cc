// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/body.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"
#include "dynamics/test_depth.h"

namespace yorb {
namespace {

/// A wall at 3 m with something at 1.5 m before it.
DepthCells WithThing(const cv::Rect& thing) {
  cv::Mat millimetres(kHeight, kWidth, CV_16UC1, cv::Scalar(3000));
  millimetres(thing & cv::Rect(0, 0, kWidth, kHeight)).setTo(1500);
  return DepthCells({millimetres, 0.001});
}

/// Of what stands at so many metres in a box.
Contrast ContrastAt(const DepthCells& depth, const Box& box, float metres) {
  const CellMask taken(depth.IndexOf(0, depth.rows()), 0);
  const CellMask in_boxes = CellsInBoxes(depth, {box});
  return ContrastOf({depth, taken, in_boxes}, box, {{{1 / metres, 0, 0}}, metres});
}

TEST(CellsInBoxes, AreThoseWhoseMiddlesTheBoxesHold) {
  const DepthCells depth = WithThing({});
  Random random(5, 1);
  std::vector<Box> boxes = {{"person", 1, -50, 2, 6, 10}, {"person", 1, 101, 101, 101.5, 101.5}};
  for (int i = 0; i < 20; ++i) {
    const double left = random.Uniform() * 700 - 30, top = random.Uniform() * 540 - 30;
    boxes.push_back({"person", 1, left, top, left + random.Uniform() * 60, top + random.Uniform() * 60});
  }
  const CellMask mask = CellsInBoxes(depth, boxes);
  for (int row = 0; row < depth.rows(); ++row) {
    for (int column = 0; column < depth.columns(); ++column) {
      const double x = (column + 0.5) * kDepthCellPx, y = (row + 0.5) * kDepthCellPx;
      const bool is_in = std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return Holds(box, x, y); });
      ASSERT_EQ(mask[depth.IndexOf(column, row)], is_in ? 1 : 0) << column << " " << row;
    }
  }
}

TEST(Contrast, IsTheShareOfTheBoxWhereNothingGoesOn) {
  const Box box{"person", 1, 200, 100, 400, 300};
  const Contrast thing = ContrastAt(WithThing({200, 100, 100, 200}), box, 1.5f);
  EXPECT_NEAR(thing.all_round, 0.5, 0.02);
  EXPECT_NEAR(thing.but_one_side, 0.5, 0.02);
  EXPECT_LT(ContrastAt(WithThing({200, 100, 100, 200}), box, 3).all_round, -0.4);
}

TEST(Contrast, ABoxThatEndsAtTheKneesCutsABody) {
  const Box box{"person", 1, 200, 100, 400, 300};
  const Contrast body = ContrastAt(WithThing({200, 100, 200, 380}), box, 1.5f);
  EXPECT_LT(body.all_round, 0.9);
  EXPECT_NEAR(body.but_one_side, 1, 0.02);
}

TEST(Contrast, AStripBelowAPersonWhoFillsThePictureSaysLittle) {
  const Box box{"person", 1, 0, 0, 640, 424};
  const Contrast body = ContrastAt(WithThing({0, 0, 640, 480}), box, 1.5f);
  EXPECT_GT(body.all_round, 0.7);
  EXPECT_NEAR(body.but_one_side, 1, 0.02);
}

TEST(Contrast, WhatIsTakenCountsForNothing) {
  const Box box{"person", 1, 200, 100, 400, 300};
  const DepthCells depth = WithThing({200, 100, 200, 200});
  const CellMask taken(depth.IndexOf(0, depth.rows()), kLying), none(taken.size(), 0);
  EXPECT_EQ(ContrastOf({depth, taken, none}, box, {{{1 / 1.5f, 0, 0}}, 1.5f}).all_round, 0);
}

TEST(FitBody, DoesNotGoFromOneBodyToTheNext) {
  cv::Mat millimetres(kHeight, kWidth, CV_16UC1, cv::Scalar(4000));
  millimetres(cv::Rect(200, 100, 90, 300)).setTo(2000);
  millimetres(cv::Rect(290, 100, 30, 300)).setTo(1670);  // an arm between the two
  millimetres(cv::Rect(320, 100, 90, 300)).setTo(1400);
  const DepthCells depth({millimetres, 0.001});
  const CellMask taken(depth.IndexOf(0, depth.rows()), 0);
  const BodyPlane body = FitBody({depth, taken, taken}, {"person", 1, 200, 100, 410, 400}, 1.65f);
  const int row = 250 / kDepthCellPx;
  EXPECT_TRUE(body.Holds(305 / kDepthCellPx, row, 1.67f));
  EXPECT_FALSE(body.Holds(210 / kDepthCellPx, row, 2.0f) && body.Holds(400 / kDepthCellPx, row, 1.4f));
}

TEST(FitBody, FollowsANearBodyThatIsTurned) {
  const auto metres_at = [](int x) { return 0.6 + 0.1 * (x - 300) / 50.0; };  // 0.5 to 0.7 m within 100 px
  cv::Mat millimetres(kHeight, kWidth, CV_16UC1, cv::Scalar(4000));
  for (int x = 250; x < 350; ++x) millimetres(cv::Rect(x, 100, 1, 300)).setTo(1000 * metres_at(x));
  const DepthCells depth({millimetres, 0.001});
  const CellMask taken(depth.IndexOf(0, depth.rows()), 0);
  const BodyPlane body = FitBody({depth, taken, taken}, {"person", 1, 250, 100, 350, 400}, 0.6f);
  for (const int x : {260, 300, 340}) {
    const float at = body.plane.DepthAt(x / kDepthCellPx, 250 / kDepthCellPx);
    EXPECT_NEAR(at, metres_at(x), 0.03) << x;
  }
}

}  // namespace
}  // namespace yorb

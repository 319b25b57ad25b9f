// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/removal_rules.h"

#include <gtest/gtest.h>

#include "dynamics/depth_cells.h"

namespace yorb {
namespace {

const Box kPerson{"person", 0.9, 100, 100, 200, 300}, kChair{"chair", 0.8, 180, 200, 260, 320};
const Box kFarChair{"chair", 0.8, 400, 200, 460, 320}, kTable{"dining table", 0.8, 90, 250, 300, 400};

Keypoint At(float x, float y) {
  Keypoint point;
  point.x = x, point.y = y;
  return point;
}

BoxRules RulesOf(const std::vector<Box>& boxes) { return BoxRules(SortByMotion(boxes, MotionTable::Default())); }

TEST(BoxRules, PointsOnWhatMovesByItselfAreDynamic) {
  const BoxRules rules = RulesOf({kPerson});
  EXPECT_EQ(rules.Judge(At(150, 150)), Verdict::kDynamic);
  EXPECT_EQ(rules.Judge(At(50, 150)), Verdict::kStatic);
}

TEST(BoxRules, RightAndBottomAreOutside) {
  const BoxRules rules = RulesOf({kPerson});
  EXPECT_EQ(rules.Judge(At(100, 100)), Verdict::kDynamic);
  EXPECT_EQ(rules.Judge(At(199, 299)), Verdict::kDynamic);
  EXPECT_EQ(rules.Judge(At(200, 150)), Verdict::kStatic);
  EXPECT_EQ(rules.Judge(At(150, 300)), Verdict::kStatic);
}

TEST(BoxRules, AStaticBoxKeepsItsPoints) {
  const BoxRules rules = RulesOf({kPerson, kTable});
  EXPECT_EQ(rules.Judge(At(150, 270)), Verdict::kStatic);
  EXPECT_EQ(rules.Judge(At(150, 150)), Verdict::kDynamic);
}

TEST(BoxRules, WhatDoesNotMoveByItselfMovesWithWhoTouchesIt) {
  const BoxRules rules = RulesOf({kChair, kFarChair, kPerson});
  EXPECT_EQ(rules.Judge(At(240, 310)), Verdict::kDynamic);
  EXPECT_EQ(rules.Judge(At(430, 250)), Verdict::kStatic);
  EXPECT_EQ(RulesOf({kChair}).Judge(At(240, 310)), Verdict::kStatic) << "nobody there";
}

TEST(BoxRules, CellsAreMarkedAsPointsAreJudged) {
  const Box table{"dining table", 0.8, 88, 248, 300, 400};  // like the others, on the borders of cells
  const BoxRules rules = RulesOf({kPerson, table, kChair, kFarChair});
  cv::Mat cells(480 / kDepthCellPx, 640 / kDepthCellPx, CV_8UC1, cv::Scalar(0));
  rules.Mark(cells);
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.cols; ++column) {
      const Keypoint point = At(static_cast<float>(column * kDepthCellPx), static_cast<float>(row * kDepthCellPx));
      ASSERT_EQ(cells.at<uint8_t>(row, column) != 0, rules.Judge(point) == Verdict::kDynamic) << column << ' ' << row;
    }
  }
}

TEST(BoxRules, UnknownThingsAreStatic) {
  EXPECT_EQ(RulesOf({{"gnu on a shelf", 1, 0, 0, 640, 480}}).Judge(At(10, 10)), Verdict::kStatic);
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/outline.h"

#include <gtest/gtest.h>

#include "dynamics/test_depth.h"

namespace yorb {
namespace {

const Box kInTheMiddle{"person", 0.9, 200, 100, 360, 400};

/// A wall that slants from 2 m on the left to 3 m on the right, and, where asked for, a board at 1.5 m within the box.
DepthImage SlantedWall(bool has_board) {
  DepthImage depth{cv::Mat(kHeight, kWidth, CV_32FC1), 1};
  for (int x = 0; x < kWidth; ++x) depth.pixels.col(x).setTo(2.0 + x / static_cast<double>(kWidth));
  if (has_board) depth.pixels(cv::Rect(205, 105, 150, 290)).setTo(1.5);
  return depth;
}

bool GoesOn(const DepthImage& image, const Box& box, float metres) {
  const DepthCells depth(image);
  const CellMask taken(static_cast<size_t>(depth.columns() * depth.rows()), 0);
  const CellMask in_boxes = CellsInBoxes(depth, {box});
  const BodySearch search{depth, taken, in_boxes};
  return GoesOnBeyond(search, box, FitBody(search, box, metres));
}

TEST(GoesOnBeyond, TellsAWallFromWhatEndsInItsBox) {
  EXPECT_TRUE(GoesOn(SlantedWall(false), kInTheMiddle, 2.44f));
  EXPECT_FALSE(GoesOn(SlantedWall(true), kInTheMiddle, 1.5f));
}

TEST(GoesOnBeyond, ABoxThatCutsABodyMakesItNoWall) {
  const Box within{"person", 0.2, 215, 120, 345, 380};  // the board is larger, by as much as faint boxes err
  EXPECT_FALSE(GoesOn(SlantedWall(true), within, 1.5f));
}

TEST(GoesOnBeyond, WhatStandsCloseBehindABodyDoesNotCount) {
  DepthImage screen = SlantedWall(true);
  screen.pixels(cv::Rect(100, 80, 400, 340)).setTo(1.75);
  screen.pixels(cv::Rect(240, 105, 80, 290)).setTo(1.5);
  EXPECT_FALSE(GoesOn(screen, kInTheMiddle, 1.5f));
}

TEST(GoesOnBeyond, TheEdgeOfThePictureSaysNothing) {
  EXPECT_FALSE(GoesOn(SlantedWall(false), {"person", 0.9, 0, 0, kWidth, kHeight}, 2.5f));
}

}  // namespace
}  // namespace yorb

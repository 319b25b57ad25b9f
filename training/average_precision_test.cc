// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/average_precision.h"

#include <gtest/gtest.h>

namespace yorb {
namespace {

SceneBox Box(float left, int class_index = 0) { return {left, 0, left + 10, 10, class_index, false}; }

TEST(ScoreClasses, PerfectBoxesScoreOneAndMissedOnesCost) {
  const auto perfect = ScoreClasses({{{Box(0), Box(50)}, {{Box(0), 0.9f}, {Box(50), 0.8f}}}}, 1);
  ASSERT_EQ(perfect.size(), 1u);
  EXPECT_NEAR(perfect[0].ap50, 1, 1e-9);
  EXPECT_NEAR(perfect[0].ap, 1, 1e-9);
  const auto half = ScoreClasses({{{Box(0), Box(50)}, {{Box(0), 0.9f}}}}, 1);
  EXPECT_NEAR(half[0].ap50, 51.0 / 101, 1e-9);  // precision 1 at the recalls 0, .01 ... .50
}

TEST(ScoreClasses, AFalseBoxAheadHalvesThePrecision) {
  const auto scores = ScoreClasses({{{Box(0)}, {{Box(80), 0.9f}, {Box(0), 0.8f}}}}, 1);
  EXPECT_NEAR(scores[0].ap50, 0.5, 1e-9);
  const auto behind = ScoreClasses({{{Box(0)}, {{Box(0), 0.9f}, {Box(80), 0.8f}}}}, 1);
  EXPECT_NEAR(behind[0].ap50, 1, 1e-9);
}

TEST(ScoreClasses, ATrueBoxIsFoundOnce) {
  const auto scores = ScoreClasses({{{Box(0), Box(50)}, {{Box(0), 0.9f}, {Box(1), 0.8f}, {Box(50), 0.7f}}}}, 1);
  EXPECT_NEAR(scores[0].ap50, (51 + 50 * 2.0 / 3) / 101, 1e-9);
}

TEST(ScoreClasses, LooseBoxesCountAtLowThresholdsOnly) {
  // An overlap of 8 of 10 px: IoU 8 / 12 = .667, right at .50, .55, .60, .65 alone.
  const auto scores = ScoreClasses({{{Box(0)}, {{Box(2), 0.9f}}}}, 1);
  EXPECT_NEAR(scores[0].ap50, 1, 1e-9);
  EXPECT_NEAR(scores[0].ap, 0.4, 1e-9);
}

TEST(ScoreClasses, OnlyClassesWithTruthAreScored) {
  const auto scores = ScoreClasses({{{Box(0, 2)}, {{Box(0, 1), 0.9f}}}}, 3);
  ASSERT_EQ(scores.size(), 1u);
  EXPECT_EQ(scores[0].class_index, 2);
  EXPECT_EQ(scores[0].ap50, 0);
}

}  // namespace
}  // namespace yorb

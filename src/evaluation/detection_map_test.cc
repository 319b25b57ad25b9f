// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/detection_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace yorb {
namespace {

JudgedBox At(double x, double confidence = 1, int label = 0) { return {label, confidence, x, 0, x + 10, 10}; }

TEST(DetectionMap, AveragePrecisionIsReadAt101Recalls) {
  // hit hit miss hit miss hit of 7: precision 1 up to recall 2/7 (29 points), 3/4 to 3/7 (14), 2/3 to 4/7 (15).
  EXPECT_NEAR(AveragePrecision({true, true, false, true, false, true}, 7), (29 + 14 * .75 + 15 * 2 / 3.0) / 101, 1e-12);
  EXPECT_NEAR(AveragePrecision({false, true, true}, 2), 2 / 3.0, 1e-12);
  EXPECT_NEAR(AveragePrecision({true}, 1), 1, 1e-12);
  EXPECT_NEAR(AveragePrecision({true}, 2), 51 / 101.0, 1e-12);  // recall .5 is reached, to the last bit
  EXPECT_EQ(AveragePrecision({}, 3), 0);
  EXPECT_EQ(AveragePrecision({false, false}, 3), 0);
}

TEST(DetectionMap, ATrueBoxIsFoundOnce) {
  const auto scores = ScoreDetections({{{At(0)}, {At(0, .9), At(1, .8)}}}, .25);
  ASSERT_EQ(scores.classes.size(), 1u);
  EXPECT_NEAR(scores.classes[0].ap50, 1, 1e-12);
  EXPECT_NEAR(*scores.classes[0].precision, .5, 1e-12);
  EXPECT_NEAR(scores.classes[0].recall, 1, 1e-12);
}

TEST(DetectionMap, TheStrongerBoxTakesTheBestTrueOneThatIsFree) {
  // The first overlaps both, the right one more; the second only the right one: it comes too late.
  const auto scores = ScoreDetections({{{At(0), At(4)}, {At(3, .9), At(4, .8)}}}, .25);
  EXPECT_NEAR(scores.classes[0].recall, .5, 1e-12);
  const auto other = ScoreDetections({{{At(0), At(4)}, {At(4, .9), At(1, .8)}}}, .25);
  EXPECT_NEAR(other.classes[0].recall, 1, 1e-12);
}

TEST(DetectionMap, TheMeanOverOverlapsTellsLooseBoxesFromTightOnes) {
  // Shifted by 1 of 10: overlap 9/11 = .818, which counts for .50 to .80, seven of ten.
  const auto scores = ScoreDetections({{{At(0)}, {At(1, .9)}}}, .25);
  EXPECT_NEAR(scores.classes[0].ap50, 1, 1e-12);
  EXPECT_NEAR(scores.classes[0].ap, .7, 1e-12);
}

TEST(DetectionMap, PicturesWithNothingInThemCount) {
  const auto scores = ScoreDetections({{{At(0)}, {At(0, .5)}}, {{}, {At(0, .9)}}}, .25);
  EXPECT_NEAR(scores.classes[0].ap50, .5, 1e-12);
  EXPECT_NEAR(*scores.classes[0].precision, .5, 1e-12);
}

TEST(DetectionMap, OnlyClassesWithTruthCount) {
  const auto scores = ScoreDetections({{{At(0, 1, 3), At(20, 1, 5)}, {At(0, .9, 3), At(40, .9, 7)}}}, .25);
  ASSERT_EQ(scores.classes.size(), 2u);
  EXPECT_EQ(scores.classes[0].label, 3);
  EXPECT_EQ(scores.classes[1].label, 5);
  EXPECT_FALSE(scores.classes[1].precision) << "nothing was found, so nothing can be said";
  EXPECT_NEAR(*scores.map50, .5, 1e-12);
  EXPECT_FALSE(ScoreDetections({{{}, {At(0)}}}, .25).map50);
}

TEST(DetectionMap, OfAClassInOnePictureTheHundredSurestMakeTheCurve) {
  JudgedPicture picture{{At(0), At(20), At(20, 1, 1)}, {At(20, .3), At(20, .2, 1)}};  // the weakest of each class
  for (int i = 0; i < 98; ++i) picture.found.push_back(At(1000 + 20 * i, .5));
  picture.found.push_back(At(0, .9));
  const auto inside = ScoreDetections({picture}, .25);
  EXPECT_NEAR(inside.classes[0].ap50, (51 + 50 * .02) / 101, 1e-12) << "the hundredth counts: 2 of 100";
  picture.found.push_back(At(5000, .5));
  const auto outside = ScoreDetections({picture, {{}, {}}}, .25);
  EXPECT_NEAR(outside.classes[0].ap50, 51 / 101.0, 1e-12) << "the hundred and first does not";
  EXPECT_NEAR(outside.classes[1].ap50, 1, 1e-12) << "another class has a hundred of its own";
  EXPECT_NEAR(outside.classes[0].recall, 1, 1e-12) << "of all boxes from the confidence up";
  EXPECT_NEAR(*outside.classes[0].precision, 2 / 101.0, 1e-12);
}

TEST(DetectionMap, WeakBoxesCountForTheCurveAlone) {
  const auto scores = ScoreDetections({{{At(0)}, {At(0, .2), At(50, .1)}}}, .25);
  EXPECT_NEAR(scores.classes[0].ap50, 1, 1e-12);
  EXPECT_EQ(scores.classes[0].recall, 0);
  EXPECT_FALSE(scores.classes[0].precision);
}

TEST(DetectionMap, OrderAmongPicturesIsByConfidence) {
  const std::vector<JudgedPicture> pictures{{{At(0)}, {At(50, .3), At(0, .9)}}, {{At(0)}, {At(0, .8), At(50, .85)}}};
  // hit (.9) miss (.85) hit (.8) miss (.3) of 2
  EXPECT_NEAR(ScoreDetections(pictures, .25).classes[0].ap50, AveragePrecision({true, false, true, false}, 2), 1e-12);
}

}  // namespace
}  // namespace yorb

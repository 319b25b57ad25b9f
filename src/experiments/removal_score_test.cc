// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/removal_score.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pictures/test_folder.h"
#include "runs/test_dataset.h"

namespace yorb {
namespace {

/// Points at these places of picture i of a recording, judged.
void Add(const Dataset& dataset, size_t i, const std::vector<cv::Point2f>& places, const std::vector<Verdict>& verdicts,
         JudgedPoints& judged) {
  const ImageSet images{dataset.TimeOf(i), {}, {}, {}, {}};
  std::vector<Keypoint> points;
  for (const cv::Point2f& place : places) points.push_back({place.x, place.y, 0, 0, 0});
  judged.Add({images, points, verdicts, MovingAreas()});
}

/// The left half of the picture moves.
void WriteMask(const TestFolder& folder, const Dataset& dataset, size_t i) {
  cv::Mat mask(dataset.rig().camera.height, dataset.rig().camera.width, CV_8UC1, cv::Scalar(0));
  mask.colRange(0, mask.cols / 2).setTo(2);
  folder.WritePicture("mask/" + ToString(dataset.TimeOf(i)) + ".png", mask);
}

TEST(ScoreRemoval, CountsPointByPoint) {
  const WallDataset wall(4);
  const TestFolder folder;
  for (const size_t i : {0, 1}) WriteMask(folder, wall, i);
  JudgedPoints judged;
  const auto moves = Verdict::kDynamic, stays = Verdict::kStatic, back = Verdict::kGivenBack;
  Add(wall, 0, {{10, 10}, {20, 20}, {30, 30}, {300, 10}, {300, 20}}, {moves, stays, back, moves, stays}, judged);
  Add(wall, 1, {{159.4f, 0}, {159.6f, 239.6f}, {-0.4f, 5}}, {moves, stays, moves}, judged);  // to the nearest pixel
  Add(wall, 2, {{10, 10}}, {moves}, judged);                                                 // has no mask
  const auto score = ScoreRemoval(judged, wall, folder.Path("mask"));
  ASSERT_TRUE(score.ok()) << score.error().message;
  EXPECT_EQ(score->num_removed_rightly, 3u);
  EXPECT_EQ(score->num_removed_wrongly, 1u);
  EXPECT_EQ(score->num_kept_wrongly, 2u);
  EXPECT_EQ(score->num_kept_rightly, 2u);
  EXPECT_DOUBLE_EQ(score->Precision(), 0.75);
  EXPECT_DOUBLE_EQ(score->Recall(), 0.6);
}

TEST(ScoreRemoval, HasNoPrecisionWhereNothingWasRemovedAndNoRecallWhereNothingMoves) {
  EXPECT_TRUE(std::isnan(RemovalScore().Precision()));
  EXPECT_TRUE(std::isnan(RemovalScore().Recall()));
}

TEST(ScoreRemoval, NamesTheFolderWhereNoMaskFits) {
  const WallDataset wall(2);
  const TestFolder folder;
  const auto missing = ScoreRemoval({}, wall, folder.Path("mask"));
  ASSERT_FALSE(missing.ok());
  EXPECT_NE(missing.error().message.find(folder.Path("mask")), std::string::npos);
  EXPECT_FALSE(ScoreRemoval({}, wall, folder.Path()).ok());
}

}  // namespace
}  // namespace yorb

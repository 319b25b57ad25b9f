// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_cells.h"

#include <gtest/gtest.h>

#include "training/scene.h"

namespace yorb {
namespace {

TEST(LabelCells, AreTheSharesOfPersonAmongWhatIsKnown) {
  cv::Mat mask(16, 24, CV_8U, cv::Scalar(kMaskNobody));
  mask(cv::Rect(8, 0, 8, 8)).setTo(kMaskPerson);
  mask(cv::Rect(16, 0, 8, 2)).setTo(kMaskPerson);
  mask(cv::Rect(0, 8, 8, 2)).setTo(kMaskUnknown);  // a quarter
  mask(cv::Rect(0, 10, 8, 3)).setTo(kMaskPerson);
  const cv::Mat labels = LabelCells(mask);
  ASSERT_EQ(labels.size(), cv::Size(3, 2));
  EXPECT_EQ(labels.at<float>(0, 0), 0.0f);
  EXPECT_EQ(labels.at<float>(0, 1), 1.0f);
  EXPECT_EQ(labels.at<float>(0, 2), 0.25f);
  EXPECT_EQ(labels.at<float>(1, 0), 0.5f);
  EXPECT_EQ(labels.at<float>(1, 1), 0.0f);
}

TEST(LabelCells, MoreThanAQuarterUnknownIsNoLabel) {
  cv::Mat mask(8, 16, CV_8U, cv::Scalar(kMaskPerson));
  mask(cv::Rect(0, 0, 8, 2)).setTo(kMaskUnknown);
  mask(cv::Rect(8, 0, 8, 2)).setTo(kMaskUnknown);
  mask.at<uint8_t>(7, 15) = kMaskUnknown;
  const cv::Mat labels = LabelCells(mask);
  EXPECT_EQ(labels.at<float>(0, 0), 1.0f);
  EXPECT_EQ(labels.at<float>(0, 1), kUnlabelledCell);
}

}  // namespace
}  // namespace yorb

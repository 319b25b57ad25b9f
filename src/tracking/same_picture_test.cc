// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/same_picture.h"

#include <gtest/gtest.h>

namespace yorb {
namespace {

Frame FrameWith(size_t num_points) {
  Frame frame;
  frame.keypoints.resize(num_points);
  frame.descriptors.resize(num_points);
  for (size_t i = 0; i < num_points; ++i) frame.keypoints[i].x = static_cast<float>(i);
  return frame;
}

TEST(SamePicture, PixelsTellWhereBothHaveThem) {
  const Frame many = FrameWith(5), few = FrameWith(3);
  const cv::Mat none, grey(4, 6, CV_8UC1, cv::Scalar(9)), same = grey.clone();
  cv::Mat other = grey.clone();
  other.at<uint8_t>(3, 5) = 8;
  EXPECT_TRUE(IsSamePicture({many, grey}, {few, same}));
  EXPECT_FALSE(IsSamePicture({many, grey}, {many, other}));
  EXPECT_FALSE(IsSamePicture({many, grey}, {many, cv::Mat(6, 4, CV_8UC1, cv::Scalar(9))}));
  EXPECT_TRUE(IsSamePicture({many, none}, {many, same}));
  EXPECT_FALSE(IsSamePicture({many, none}, {few, same}));
}

TEST(SamePicture, BlackOnesAreNot) {
  const Frame nothing = FrameWith(0);
  const cv::Mat black(4, 6, CV_8UC1, cv::Scalar(0));
  EXPECT_FALSE(IsSamePicture({nothing, black}, {nothing, black}));
  EXPECT_FALSE(IsSamePicture({nothing, cv::Mat()}, {nothing, cv::Mat()}));
}

}  // namespace
}  // namespace yorb

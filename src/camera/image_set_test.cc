// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/image_set.h"

#include <gtest/gtest.h>

#include <limits>

namespace yorb {
namespace {

TEST(DepthImage, UnitsBecomeMetresAndHolesZero) {
  cv::Mat pixels(1, 4, CV_16UC1);
  const uint16_t units[] = {0, 5000, 65535, 1};
  for (int x = 0; x < 4; ++x) pixels.at<uint16_t>(0, x) = units[x];
  const DepthImage depth{pixels, 1.0 / 5000};
  EXPECT_EQ(depth.At(0, 0), 0);
  EXPECT_FLOAT_EQ(depth.At(1, 0), 1);
  EXPECT_EQ(depth.At(2, 0), 0) << "65535 means not measured";
  EXPECT_EQ(depth.StoredMetres(2, 0), 0);
  EXPECT_FLOAT_EQ(depth.At(3, 0), 0.0002f);
}

TEST(DepthImage, FloatsAreMetresWhateverTheFactor) {
  cv::Mat pixels(1, 5, CV_32FC1);
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const float metres[] = {2.5f, nan, inf, -1.f, 0.f};
  for (int x = 0; x < 5; ++x) pixels.at<float>(0, x) = metres[x];
  const DepthImage depth{pixels, 1.0 / 5000};
  EXPECT_EQ(depth.At(0, 0), 2.5f);
  for (int x = 1; x < 5; ++x) EXPECT_EQ(depth.At(x, 0), 0) << x;
}

TEST(DepthImage, WhatNoCameraCanSeeIsNotMeasured) {
  const DepthImage absurd{cv::Mat(1, 1, CV_16UC1, cv::Scalar(5)), 1e300};
  EXPECT_EQ(absurd.At(0, 0), 0);
  EXPECT_DOUBLE_EQ(absurd.StoredMetres(0, 0), 5e300) << "as it is stored";
  const DepthImage far_away{cv::Mat(1, 1, CV_32FC1, cv::Scalar(1e30)), 1};
  EXPECT_EQ(far_away.At(0, 0), 0);
}

TEST(DepthImage, IsEmptyWithoutPixels) { EXPECT_TRUE(DepthImage().empty()); }

}  // namespace
}  // namespace yorb

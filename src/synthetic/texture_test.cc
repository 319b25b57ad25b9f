// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/texture.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace yorb {
namespace {

cv::Mat RandomPicture(int width, int height) {
  Random random(3);
  cv::Mat picture(height, width, CV_8UC3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) picture.at<cv::Vec3b>(y, x)[c] = static_cast<uchar>(random.Below(256));
    }
  }
  return picture;
}

TEST(Texture, GivesTheTexelsThemselvesAtTheirCentres) {
  const cv::Mat picture = RandomPicture(16, 8);
  const Texture texture(picture);
  const Eigen::Vector2f right(0.5f / 16, 0), down(0, 0.5f / 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      for (const int round : {0, 3, -2}) {  // and repeats without end
        const Eigen::Vector2f uv((static_cast<float>(x) + 0.5f) / 16 + static_cast<float>(round),
                                 (static_cast<float>(y) + 0.5f) / 8);
        const Eigen::Array3f colour = texture.Sample(uv, right, down);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour[c], picture.at<cv::Vec3b>(y, x)[c], 1.0);
      }
    }
  }
}

TEST(Texture, IsLinearBetweenTexels) {
  cv::Mat ramp(4, 16, CV_8UC3);
  for (int x = 0; x < 16; ++x) ramp.col(x).setTo(cv::Scalar(10 * x, 5 * x, 100));
  const Texture texture(ramp);
  for (float at = 1; at < 15; at += 0.37f) {
    const Eigen::Array3f colour = texture.Sample({(at + 0.5f) / 16, 0.4f}, {0.5f / 16, 0}, {0, 0.5f / 4});
    EXPECT_NEAR(colour[0], 10 * at, 0.1);
    EXPECT_NEAR(colour[1], 5 * at, 0.1);
    EXPECT_NEAR(colour[2], 100, 1e-3);
  }
}

TEST(Texture, AveragesOverWhatAPixelSees) {
  const cv::Mat picture = RandomPicture(64, 64);
  const Texture texture(picture);
  const cv::Scalar mean = cv::mean(picture);
  const Eigen::Array3f all = texture.Sample({0.3f, 0.6f}, {1, 0}, {0, 1});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(all[c], mean[c], 2);
  // A pixel that is stretched along a texture of rows sees one row alone, not the mean of all.
  cv::Mat rows(64, 64, CV_8UC3);
  for (int y = 0; y < 64; ++y) rows.row(y).setTo(cv::Scalar::all(y % 8 < 4 ? 200 : 40));
  const Texture striped(rows);
  EXPECT_NEAR(striped.Sample({0.3f, 2.f / 64}, {6.f / 64, 0}, {0, 1.f / 64})[0], 200, 1);
  EXPECT_NEAR(striped.Sample({0.3f, 6.f / 64}, {6.f / 64, 0}, {0, 1.f / 64})[0], 40, 1);
  // Across the rows it sees them all.
  EXPECT_NEAR(striped.Sample({0.3f, 6.f / 64}, {0, 8.f / 64}, {8.f / 64, 0})[0], 120, 12);
}

}  // namespace
}  // namespace yorb

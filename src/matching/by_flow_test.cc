// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/by_flow.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace yorb {
namespace {

/// Soft blobs of all sizes about a corner, so that there is something to follow at every scale.
cv::Mat Texture() {
  cv::Mat picture(240, 320, CV_8UC1);
  cv::RNG random(3);
  random.fill(picture, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(picture, picture, {}, 3);
  cv::normalize(picture, picture, 0, 255, cv::NORM_MINMAX);
  return picture;
}

cv::Mat Moved(const cv::Mat& picture, double dx, double dy) {
  const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, dx, 0, 1, dy);
  cv::Mat moved;
  cv::warpAffine(picture, moved, shift, picture.size(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
  return moved;
}

std::vector<FlowGuess> GridOfGuesses(const Eigen::Vector2f& expected) {
  std::vector<FlowGuess> guesses;
  for (int y = 60; y <= 180; y += 20) {
    for (int x = 60; x <= 260; x += 20) {
      const Eigen::Vector2f px(static_cast<float>(x), static_cast<float>(y));
      guesses.push_back({px, px + expected});
    }
  }
  return guesses;
}

TEST(FollowByFlow, FindsAShiftFromAGuessThatIsOffEvenInABlurredPicture) {
  const cv::Mat from = Texture();
  const Eigen::Vector2f shift(17.4f, -9.25f);
  cv::Mat to = Moved(from, static_cast<double>(shift.x()), static_cast<double>(shift.y()));
  cv::blur(to, to, {9, 1});
  const auto guesses = GridOfGuesses({12, -4});
  const auto followed = FollowByFlow(from, to, guesses);
  ASSERT_EQ(followed.size(), guesses.size());
  size_t num_found = 0;
  for (size_t i = 0; i < guesses.size(); ++i) {
    if (!followed[i]) continue;
    ++num_found;
    EXPECT_LT((*followed[i] - guesses[i].from_px - shift).norm(), 1) << i;
  }
  EXPECT_GT(num_found, guesses.size() * 9 / 10);
}

TEST(FollowByFlow, LosesWhatIsNotThereAnyMore) {
  const cv::Mat from = Texture();
  cv::Mat to = Moved(from, 3, 2);
  to.colRange(160, 320) = 128;  // no texture at all
  const auto guesses = GridOfGuesses({3, 2});
  const auto followed = FollowByFlow(from, to, guesses);
  for (size_t i = 0; i < guesses.size(); ++i) {
    const float x = guesses[i].to_px.x();
    if (x > 140 && x < 180) continue;  // about the border
    EXPECT_EQ(followed[i].has_value(), x < 160) << i;
  }
}

TEST(FollowByFlow, TakesNothingAndPicturesOfTwoSizes) {
  const cv::Mat picture = Texture();
  EXPECT_TRUE(FollowByFlow(picture, picture, {}).empty());
  const std::vector<FlowGuess> one{{{100, 100}, {100, 100}}};
  EXPECT_FALSE(FollowByFlow({}, picture, one)[0]);
  EXPECT_FALSE(FollowByFlow(picture, picture.rowRange(0, 100), one)[0]);
}

}  // namespace
}  // namespace yorb

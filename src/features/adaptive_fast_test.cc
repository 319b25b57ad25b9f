// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/adaptive_fast.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "features/test_pictures.h"

namespace yorb {
namespace {

cv::Mat Scaled(const cv::Mat& picture, double gain) {
  cv::Mat scaled;
  picture.convertTo(scaled, CV_8U, gain);
  return scaled;
}

size_t CountFirst(const cv::Mat& picture, const CornerOptions& options) {
  CornerDetector detector;
  return detector.DetectFirst(Padded(picture).View(), options, BestInstructions()).size();
}

TEST(CornerDetector, AdaptiveThresholdHoldsTheCountUnderScaledLight) {
  CornerOptions adaptive, fixed;
  fixed.is_adaptive = false, fixed.high = 40;
  adaptive.alpha = 0.4;
  cv::Mat picture = RectanglesPicture(640, 480, 1, 0);
  picture = picture * 0.6 + 10;  // nothing reaches white at 140 %
  const double ours = static_cast<double>(CountFirst(picture, adaptive));
  const double theirs = static_cast<double>(CountFirst(picture, fixed));
  ASSERT_GT(ours, 200);
  for (const double gain : {0.6, 1.4}) {
    const double our_change = static_cast<double>(CountFirst(Scaled(picture, gain), adaptive)) / ours - 1;
    const double their_change = static_cast<double>(CountFirst(Scaled(picture, gain), fixed)) / theirs - 1;
    EXPECT_LT(std::abs(our_change), 0.07) << gain;
    EXPECT_GT(std::abs(their_change), 0.15) << gain;
  }
}

TEST(CornerDetector, FirstThresholdIsEquationThree) {
  CornerOptions options;
  options.alpha = 0.35;
  const GreyImage image = Padded(RectanglesPicture(320, 240, 2));
  CornerDetector detector;
  Fast fast;
  std::vector<Corner> expected =
      fast.Detect(image.View(), {options.noise, options.arc, options.border}, Instructions::kPortable);
  std::erase_if(expected, [&](const Corner& c) {
    return c.score + 1 <= 0.35 * TrimmedRingSum(image.View(), c.x, c.y, Instructions::kPortable) / 14;
  });
  const std::vector<Corner>& found = detector.DetectFirst(image.View(), options, BestInstructions());
  ASSERT_GT(expected.size(), 50u);
  EXPECT_NEAR(static_cast<double>(found.size()), static_cast<double>(expected.size()), 1)
      << "alpha is rounded to 1/4096";
}

TEST(CornerDetector, OnlyEmptyCellsGetTheSecondThreshold) {
  // Left: strong squares. Right: weak ones, below the first threshold.
  cv::Mat picture(200, 400, CV_8UC1, cv::Scalar(100));
  for (int y = 25; y < 180; y += 15) {
    for (int x = 25; x < 180; x += 15) cv::rectangle(picture, {x, y, 6, 6}, cv::Scalar(200), cv::FILLED);
    for (int x = 240; x < 370; x += 15) cv::rectangle(picture, {x, y, 6, 6}, cv::Scalar(112), cv::FILLED);
  }
  cv::GaussianBlur(picture, picture, cv::Size(3, 3), 0.8);  // a flat square ties with itself
  CornerOptions options;
  options.is_adaptive = false, options.low = 4;
  CornerDetector detector;
  const std::vector<Corner>& corners = detector.Detect(Padded(picture).View(), options, 0, BestInstructions());
  const auto is_weak = [](const Corner& c) { return c.score < 20; };
  EXPECT_GT(std::count_if(corners.begin(), corners.end(), is_weak), 50);
  for (const Corner& c : corners) EXPECT_EQ(c.x >= 200, is_weak(c)) << c.x;
}

TEST(CornerDetector, AStarvedPictureGetsItsStrongestCorners) {
  // Bright and of little contrast: equation (3) asks for more than there is.
  cv::Mat picture = RectanglesPicture(320, 240, 3, 0);
  picture = picture * 0.15 + 200;
  const GreyImage image = Padded(picture);
  CornerOptions options;
  options.choice = 0;
  CornerDetector detector;
  const size_t alone = detector.Detect(image.View(), options, 0, BestInstructions()).size();
  const std::vector<Corner>& filled = detector.Detect(image.View(), options, 130, BestInstructions());
  EXPECT_LT(alone, 120u);
  EXPECT_EQ(filled.size(), 130u);
  for (const Corner& c : filled) EXPECT_GE(c.score, options.noise);
  EXPECT_TRUE(std::is_sorted(filled.begin(), filled.end(),
                             [](const Corner& a, const Corner& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }));
}

TEST(CornerDetector, TheStrongestForTheirNeighbourhoodStayInHalfALight) {
  const cv::Mat picture = RectanglesPicture(640, 480, 4, 0);
  cv::Mat half = picture.clone();
  half.colRange(0, 320) *= 0.4;
  CornerOptions by_strength, by_cells, fixed;
  by_cells.choice = 0;
  fixed.is_adaptive = false;
  CornerDetector detector;
  const auto best = [&](const cv::Mat& grey, const CornerOptions& options) {
    std::vector<Corner> corners = detector.Detect(Padded(grey).View(), options, 200, BestInstructions());
    const size_t count = std::min<size_t>(200, corners.size());
    std::partial_sort(corners.begin(), corners.begin() + static_cast<ptrdiff_t>(count), corners.end(),
                      [](const Corner& a, const Corner& b) { return a.response > b.response; });
    std::set<std::pair<int, int>> places;
    for (size_t i = 0; i < count; ++i) places.emplace(corners[i].x, corners[i].y);
    return places;
  };
  const auto share_kept = [&](const CornerOptions& options) {
    const auto before = best(picture, options), after = best(half, options);
    size_t kept = 0;
    for (const auto& place : before) kept += after.count(place);
    return static_cast<double>(kept) / static_cast<double>(before.size());
  };
  EXPECT_GT(share_kept(by_strength), 0.8);
  EXPECT_LT(share_kept(by_cells), 0.7);
  EXPECT_LT(share_kept(fixed), 0.7);
}

TEST(CornerDetector, AsksForAsManyCornersInAnyLight) {
  const cv::Mat picture = RectanglesPicture(640, 480, 5) * 0.7;
  CornerDetector detector;
  for (const double gain : {0.3, 1.0, 1.4}) {
    const auto& corners = detector.Detect(Padded(Scaled(picture, gain)).View(), {}, 200, BestInstructions());
    EXPECT_GE(corners.size(), 200u) << gain;
    EXPECT_LE(corners.size(), 240u) << gain;
    EXPECT_TRUE(std::all_of(corners.begin(), corners.end(), [](const Corner& c) { return c.response > 0; }));
  }
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/fast.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/features2d.hpp>

#include "features/fast_rows.h"
#include "features/test_pictures.h"

namespace yorb {
namespace {

/// Equations (1) and (2), word by word.
bool IsCorner(const GreyView& level, int x, int y, int threshold, int arc) {
  const int centre = level.Row(y)[x];
  for (int first = 0; first < fast::kRing; ++first) {
    bool is_brighter = true, is_darker = true;
    for (int i = first; i < first + arc; ++i) {
      const int pixel = level.Row(y + fast::kRingY[i % 16])[x + fast::kRingX[i % 16]];
      is_brighter = is_brighter && pixel > centre + threshold;
      is_darker = is_darker && pixel < centre - threshold;
    }
    if (is_brighter || is_darker) return true;
  }
  return false;
}

/// The slow twin of the score map.
int SlowScore(const GreyView& level, int x, int y, const FastOptions& options) {
  if (!IsCorner(level, x, y, options.threshold, options.arc)) return 0;
  int score = options.threshold;
  while (score < 255 && IsCorner(level, x, y, score + 1, options.arc)) ++score;
  return score;
}

std::vector<Corner> SlowDetect(const GreyView& level, const FastOptions& options) {
  cv::Mat scores = cv::Mat::zeros(level.height, level.width, CV_32S);
  for (int y = 3; y < level.height - 3; ++y) {
    for (int x = 3; x < level.width - 3; ++x) scores.at<int>(y, x) = SlowScore(level, x, y, options);
  }
  std::vector<Corner> corners;
  for (int y = options.border; y < level.height - options.border; ++y) {
    for (int x = options.border; x < level.width - options.border; ++x) {
      const int score = scores.at<int>(y, x);
      bool is_peak = score > 0;
      for (int i = 0; i < 9; ++i) {
        if (i != 4) is_peak = is_peak && score > scores.at<int>(y + i / 3 - 1, x + i % 3 - 1);
      }
      if (is_peak) corners.push_back({x, y, score, 0.f, 0.f, 0.f});
    }
  }
  return corners;
}

void ExpectEqual(const std::vector<Corner>& ours, const std::vector<Corner>& theirs) {
  ASSERT_EQ(ours.size(), theirs.size());
  for (size_t i = 0; i < ours.size(); ++i) {
    EXPECT_EQ(ours[i].x, theirs[i].x);
    EXPECT_EQ(ours[i].y, theirs[i].y);
    EXPECT_EQ(ours[i].score, theirs[i].score);
  }
}

TEST(Fast, AllPathsFindTheSlowTwinsCorners) {
  size_t found = 0;
  for (const cv::Mat& picture :
       {RectanglesPicture(131, 90, 1), NoisePicture(75, 64, 2), RectanglesPicture(39, 39, 3)}) {
    const GreyImage image = Padded(picture);
    for (const int arc : {9, 10, 11, 12}) {
      for (const int threshold : {1, 7, 20, 60}) {
        const FastOptions options{threshold, arc, 19};
        const std::vector<Corner> expected = SlowDetect(image.View(), options);
        for (const Instructions path : {Instructions::kPortable, BestInstructions()}) {
          Fast fast;
          ExpectEqual(fast.Detect(image.View(), options, path), expected);
        }
        found += expected.size();
      }
    }
  }
  EXPECT_GT(found, 1000u);
}

TEST(Fast, FindsOpenCvsCornersAndScores) {
  const cv::Mat picture = RectanglesPicture(320, 240, 4);
  const GreyImage image = Padded(picture);
  std::vector<cv::KeyPoint> keypoints;
  cv::FAST(picture, keypoints, 20, true, cv::FastFeatureDetector::TYPE_9_16);
  std::erase_if(keypoints, [](const cv::KeyPoint& k) {
    return k.pt.x < 19 || k.pt.y < 19 || k.pt.x >= 320 - 19 || k.pt.y >= 240 - 19;
  });
  std::vector<Corner> theirs;
  for (const cv::KeyPoint& k : keypoints) {
    theirs.push_back({static_cast<int>(k.pt.x), static_cast<int>(k.pt.y), static_cast<int>(k.response), 0.f, 0.f, 0.f});
  }
  Fast fast;
  ASSERT_GT(theirs.size(), 100u);
  ExpectEqual(fast.Detect(image.View(), {20, 9, 19}, BestInstructions()), theirs);
}

TEST(Fast, OneMapHoldsTheCornersOfAllHigherThresholds) {
  const GreyImage image = Padded(RectanglesPicture(320, 240, 5));
  Fast low, high;
  std::vector<Corner> among = low.Detect(image.View(), {7, 9, 19}, BestInstructions());
  std::erase_if(among, [](const Corner& corner) { return corner.score < 20; });
  ExpectEqual(high.Detect(image.View(), {20, 9, 19}, BestInstructions()), among);
}

TEST(Fast, FindsNothingInASmallPicture) {
  Fast fast;
  EXPECT_TRUE(fast.Detect(Padded(NoisePicture(38, 200, 6)).View(), {7, 9, 19}, BestInstructions()).empty());
  EXPECT_TRUE(fast.Detect(Padded(NoisePicture(200, 1, 6)).View(), {7, 9, 19}, BestInstructions()).empty());
}

TEST(Fast, RingSumLeavesOutTheExtremes) {
  const GreyImage image = Padded(NoisePicture(80, 60, 7));
  for (int y = 3; y < 57; ++y) {
    for (int x = 3; x < 77; ++x) {
      std::vector<int> ring;
      for (int i = 0; i < 16; ++i) ring.push_back(image.View().Row(y + fast::kRingY[i])[x + fast::kRingX[i]]);
      std::sort(ring.begin(), ring.end());
      const int expected = std::accumulate(ring.begin() + 1, ring.end() - 1, 0);
      EXPECT_EQ(TrimmedRingSum(image.View(), x, y, Instructions::kPortable), expected);
      EXPECT_EQ(TrimmedRingSum(image.View(), x, y, BestInstructions()), expected);
    }
  }
}

TEST(Fast, RefinesTowardsTheStrongerNeighbour) {
  const GreyImage image = Padded(RectanglesPicture(320, 240, 8));
  Fast fast;
  for (const Instructions instructions : {BestInstructions(), Instructions::kPortable}) {
    for (const Corner& found : fast.Detect(image.View(), {20, 9, 19}, instructions)) {
      const Corner refined = Refined(found);
      const auto score = [&](int x, int y) { return SlowScore(image.View(), x, y, {20, 9, 3}); };
      EXPECT_LE(std::max(std::abs(refined.dx), std::abs(refined.dy)), 0.5);
      EXPECT_EQ(found.beside.left, score(found.x - 1, found.y));
      EXPECT_EQ(found.beside.right, score(found.x + 1, found.y));
      EXPECT_EQ(refined.dx > 0, score(found.x + 1, found.y) > score(found.x - 1, found.y));
      EXPECT_EQ(refined.dy > 0, score(found.x, found.y + 1) > score(found.x, found.y - 1));
    }
  }
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/trim.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"

namespace yorb {
namespace {

/// Points all over a picture, the strong ones in its upper left corner.
Features Crowded(size_t count) {
  Random random(5);
  Features features;
  for (size_t i = 0; i < count; ++i) {
    Keypoint keypoint;
    const bool is_in_corner = i % 2 == 0;
    keypoint.x = static_cast<float>(random.Uniform(0, is_in_corner ? 80 : 640));
    keypoint.y = static_cast<float>(random.Uniform(0, is_in_corner ? 60 : 480));
    keypoint.response = static_cast<float>(random.Uniform(0, 50) + (is_in_corner ? 50 : 0));
    features.keypoints.push_back(keypoint);
    features.descriptors.push_back({i, 0, 0, 0});
  }
  return features;
}

TEST(Trim, ByResponseDropsTheWeakestAndKeepsRowsTogetherInOrder) {
  const Features all = Crowded(400);
  const Features kept = Trim(all, 100, TrimBy::kResponse);
  ASSERT_EQ(kept.keypoints.size(), 100u);
  ASSERT_EQ(kept.descriptors.size(), 100u);
  float weakest = 1e9f;
  for (size_t i = 0; i < kept.keypoints.size(); ++i) {
    const size_t row = kept.descriptors[i][0];
    EXPECT_EQ(kept.keypoints[i].response, all.keypoints[row].response);
    if (i > 0) {
      EXPECT_LT(kept.descriptors[i - 1][0], row);
    }
    weakest = std::min(weakest, kept.keypoints[i].response);
  }
  const auto stronger = std::count_if(all.keypoints.begin(), all.keypoints.end(),
                                      [&](const Keypoint& keypoint) { return keypoint.response > weakest; });
  EXPECT_EQ(stronger, 99);
}

TEST(Trim, BySpreadKeepsPointsEverywhere) {
  const auto outside = [](const Features& features) {
    return std::count_if(features.keypoints.begin(), features.keypoints.end(),
                         [](const Keypoint& keypoint) { return keypoint.x > 80 || keypoint.y > 60; });
  };
  const Features all = Crowded(1000);
  EXPECT_EQ(outside(Trim(all, 320, TrimBy::kResponse)), 0);
  EXPECT_GT(outside(Trim(all, 320, TrimBy::kSpread)), 250);
  EXPECT_EQ(Trim(all, 320, TrimBy::kSpread).keypoints.size(), 320u);
}

TEST(Trim, LeavesFewPointsAlone) {
  const Features few = Crowded(10);
  EXPECT_EQ(Trim(few, 10, TrimBy::kSpread).descriptors, few.descriptors);
  EXPECT_EQ(Trim(few, 11, TrimBy::kResponse).descriptors, few.descriptors);
  EXPECT_TRUE(Trim({}, 5, TrimBy::kSpread).keypoints.empty());
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/nms.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/iou.h"
#include "core/random.h"
#include "detection/letterbox.h"

namespace yorb {
namespace {

TEST(Nms, TheStrongestOfEachClassStays) {
  const std::vector<RawBox> boxes{
      {0, 0, 10, 10, .5f, 0}, {1, 0, 11, 10, .9f, 0}, {0, 0, 10, 10, .4f, 1}, {50, 50, 60, 60, .3f, 0}};
  const auto kept = SuppressDoubles(boxes, .45, 100);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[0].confidence, .9f);
  EXPECT_EQ(kept[1].label, 1);
  EXPECT_EQ(kept[2].left, 50);
  EXPECT_EQ(SuppressDoubles(boxes, .45, 2).size(), 2u);
  EXPECT_EQ(SuppressDoubles(boxes, 1, 100).size(), 4u);
  EXPECT_TRUE(SuppressDoubles({}, .45, 100).empty());
}

/// As the rule is told: take the strongest box that is left, strike out its doubles.
std::vector<RawBox> SlowSuppress(std::vector<RawBox> boxes, double most_overlap) {
  std::vector<RawBox> kept;
  while (!boxes.empty()) {
    const auto best = std::max_element(boxes.begin(), boxes.end(),
                                       [](const RawBox& a, const RawBox& b) { return a.confidence < b.confidence; });
    const RawBox chosen = *best;
    kept.push_back(chosen);
    boxes.erase(best);
    boxes.erase(
        std::remove_if(boxes.begin(), boxes.end(),
                       [&](const RawBox& box) { return box.label == chosen.label && IoU(box, chosen) > most_overlap; }),
        boxes.end());
  }
  return kept;
}

TEST(Nms, GivesWhatTheSlowWayGives) {
  Random random(11);
  std::vector<RawBox> boxes;
  for (int i = 0; i < 400; ++i) {
    const auto x = static_cast<float>(random.Uniform(0, 100)), y = static_cast<float>(random.Uniform(0, 100));
    boxes.push_back({x, y, x + 20, y + 30, static_cast<float>(random.Uniform()), static_cast<int>(random.Below(3))});
  }
  const auto fast = SuppressDoubles(boxes, .3, 1000), slow = SlowSuppress(boxes, .3);
  ASSERT_EQ(fast.size(), slow.size());
  for (size_t i = 0; i < fast.size(); ++i) EXPECT_EQ(fast[i].confidence, slow[i].confidence);
}

TEST(Letterbox, KeepsTheShapeAndFindsTheWayBack) {
  for (const cv::Size picture :
       {cv::Size(640, 480), cv::Size(480, 640), cv::Size(64, 64), cv::Size(1000, 3), cv::Size(17, 31)}) {
    const Letterbox box = FitLetterbox(picture, {320, 256});
    EXPECT_LE(box.scaled.width, 320);
    EXPECT_LE(box.scaled.height, 256);
    EXPECT_TRUE(box.scaled.width == 320 || box.scaled.height == 256);
    EXPECT_NEAR(box.ToPictureX(box.left), 0, 1e-9);
    EXPECT_NEAR(box.ToPictureX(box.left + box.scaled.width), picture.width, 1e-9);
    EXPECT_NEAR(box.ToPictureY(box.top + box.scaled.height), picture.height, 1e-9);
  }
}

TEST(Letterbox, FramesWithGrey) {
  const cv::Mat white(50, 100, CV_8UC3, cv::Scalar::all(255));
  const Letterbox box = FitLetterbox(white.size(), {64, 64});
  const cv::Mat framed = Letterboxed(white, box);
  ASSERT_EQ(framed.size(), cv::Size(64, 64));
  EXPECT_EQ(framed.at<cv::Vec3b>(0, 32), cv::Vec3b(114, 114, 114));
  EXPECT_EQ(framed.at<cv::Vec3b>(63, 32), cv::Vec3b(114, 114, 114));
  EXPECT_EQ(framed.at<cv::Vec3b>(16, 0), cv::Vec3b(255, 255, 255));
  EXPECT_EQ(framed.at<cv::Vec3b>(47, 63), cv::Vec3b(255, 255, 255));
}

}  // namespace
}  // namespace yorb

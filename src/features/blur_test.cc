// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/blur.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "features/test_pictures.h"

namespace yorb {
namespace {

/// cv::ORB blurs a part of a larger picture, which takes another way through OpenCV than a whole one.
cv::Mat BlurWithinOrb(const cv::Mat& picture) {
  cv::Mat framed, blurred;
  cv::copyMakeBorder(picture, framed, 8, 8, 8, 8, cv::BORDER_REFLECT_101);
  cv::GaussianBlur(framed(cv::Rect(8, 8, picture.cols, picture.rows)), blurred, cv::Size(7, 7), 2, 2,
                   cv::BORDER_REFLECT_101);
  return blurred;
}

int CountDifferent(const GreyView& a, const GreyView& b, int tolerance) {
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) count += std::abs(a.Row(y)[x] - b.Row(y)[x]) > tolerance;
  }
  return count;
}

TEST(Blur, BothPathsGiveTheSameBits) {
  for (const cv::Mat& picture :
       {NoisePicture(640, 480, 1), NoisePicture(333, 97, 2), NoisePicture(9, 8, 3), NoisePicture(2, 3, 4),
        NoisePicture(1, 1, 5), cv::Mat(50, 60, CV_8UC1, cv::Scalar(255))}) {
    const GreyImage image = Padded(picture);
    Blur portable, wide;
    const GreyView a = portable.Apply(image.View(), Instructions::kPortable);
    const GreyView b = wide.Apply(image.View(), BestInstructions());
    EXPECT_EQ(CountDifferent(a, b, 0), 0) << picture.size();
  }
}

TEST(Blur, IsOpenCvsWithinOrb) {
  for (const cv::Mat& picture : {NoisePicture(640, 480, 6), RectanglesPicture(517, 389, 7)}) {
    const GreyImage image = Padded(picture), expected = Padded(BlurWithinOrb(picture));
    Blur blur;
    const GreyView ours = blur.Apply(image.View(), BestInstructions());
    // OpenCV's own result depends on the processor: without fused multiply-adds a few pixels in a million differ by
    // one.
    const bool has_fma = BestInstructions() == Instructions::kAvx2;
    EXPECT_LE(CountDifferent(ours, expected.View(), 0), has_fma ? 0 : 10);
    EXPECT_EQ(CountDifferent(ours, expected.View(), 1), 0);
  }
}

}  // namespace
}  // namespace yorb

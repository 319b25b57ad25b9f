// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/pyramid.h"

#include <gtest/gtest.h>

#include <cstring>

#include "features/test_pictures.h"

namespace yorb {
namespace {

GreyView ViewOf(const cv::Mat& picture) {
  return {picture.data, picture.cols, picture.rows, static_cast<ptrdiff_t>(picture.step[0])};
}

bool IsEqual(const GreyView& view, const cv::Mat& picture) {
  if (view.width != picture.cols || view.height != picture.rows) return false;
  for (int y = 0; y < view.height; ++y) {
    if (std::memcmp(view.Row(y), picture.ptr(y), static_cast<size_t>(view.width)) != 0) return false;
  }
  return true;
}

class PyramidTest : public testing::TestWithParam<double> {};

TEST_P(PyramidTest, LevelsAreOpenCvsExactResize) {
  const double factor = GetParam();
  for (const cv::Mat& picture : {NoisePicture(640, 480, 1), NoisePicture(313, 207, 2), NoisePicture(64, 33, 3)}) {
    for (const Instructions path : {Instructions::kPortable, BestInstructions()}) {
      Pyramid pyramid;
      pyramid.Build(ViewOf(picture), 8, factor, path);
      cv::Mat expected = picture;
      for (int level = 0; level < pyramid.levels(); ++level) {
        const GreyView& view = pyramid.Level(level);
        if (view.empty()) break;
        if (level > 0) {
          cv::Mat smaller;
          cv::resize(expected, smaller, cv::Size(view.width, view.height), 0, 0, cv::INTER_LINEAR_EXACT);
          expected = smaller;
        }
        EXPECT_TRUE(IsEqual(view, expected)) << "level " << level << " of " << picture.size();
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Factors, PyramidTest, testing::Values(1.05, 1.2, 1.5, 2.0));

TEST(Pyramid, SizesAreRoundedFromThePicture) {
  Pyramid pyramid;
  pyramid.Build(ViewOf(NoisePicture(640, 480, 4)), 8, 1.2, BestInstructions());
  const int widths[] = {640, 533, 444, 370, 309, 257, 214, 179}, heights[] = {480, 400, 333, 278, 231, 193, 161, 134};
  for (int level = 0; level < 8; ++level) {
    EXPECT_EQ(pyramid.Level(level).width, widths[level]);
    EXPECT_EQ(pyramid.Level(level).height, heights[level]);
  }
}

TEST(Pyramid, NothingStaysOfAnEarlierPicture) {
  Pyramid used, fresh;
  const cv::Mat small = NoisePicture(200, 150, 6);
  used.Build(ViewOf(NoisePicture(320, 240, 5)), 8, 1.2, BestInstructions());
  used.Build(ViewOf(small), 4, 1.2, BestInstructions());
  fresh.Build(ViewOf(small), 4, 1.2, BestInstructions());
  ASSERT_EQ(used.levels(), 4);
  for (int level = 0; level < 4; ++level) {
    const GreyView& view = fresh.Level(level);
    EXPECT_TRUE(IsEqual(used.Level(level), cv::Mat(view.height, view.width, CV_8UC1, const_cast<uint8_t*>(view.pixels),
                                                   static_cast<size_t>(view.stride))));
  }
}

TEST(Pyramid, TinyAndEmptyPicturesEndEarly) {
  Pyramid pyramid;
  pyramid.Build(ViewOf(NoisePicture(1, 2, 7)), 8, 2.0, BestInstructions());
  EXPECT_EQ(pyramid.Level(0).width, 1);
  EXPECT_TRUE(pyramid.Level(7).empty());
  pyramid.Build(GreyView{}, 3, 1.2, BestInstructions());
  EXPECT_TRUE(pyramid.Level(0).empty());
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/masked_dataset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pictures/test_folder.h"

namespace yorb {
namespace {

using testing::HasSubstr;

/// Two grey pictures.
class TwoPictures : public Dataset {
 public:
  size_t size() const override { return 2; }
  Timestamp TimeOf(size_t i) const override { return {static_cast<int64_t>(i + 1) * 1'500'000'000}; }
  std::string PictureName(size_t i) const override { return "rgb/picture" + std::to_string(i) + ".jpg"; }
  const Rig& rig() const override { return rig_; }
  Result<LoadedFrame> Load(size_t i) const override {
    LoadedFrame frame;
    frame.images.emplace();
    frame.images->timestamp = TimeOf(i);
    frame.images->grey = cv::Mat(30, 40, CV_8UC1, cv::Scalar(50));
    return frame;
  }

 private:
  Rig rig_;
};

class MaskedDatasetTest : public testing::Test {
 protected:
  void WriteMask(const std::string& name, const cv::Mat& mask) { folder_.WritePicture(name, mask); }
  static cv::Mat LeftHalf(int type = CV_8UC1) {
    cv::Mat mask(30, 40, type, cv::Scalar::all(0));
    mask.colRange(0, 20).setTo(cv::Scalar(1, 0, 0));
    return mask;
  }

  TestFolder folder_;
  TwoPictures source_;
};

TEST_F(MaskedDatasetTest, MasksAreFoundByNameAndByTimeStamp) {
  WriteMask("picture0.png", LeftHalf());
  WriteMask("3.0.png", LeftHalf(CV_8UC3));
  const auto masked = MaskedDataset::Open(source_, folder_.Path(""));
  ASSERT_TRUE(masked.ok()) << masked.error().message;
  for (size_t i = 0; i < 2; ++i) {
    const auto frame = (*masked)->Load(i);
    ASSERT_TRUE(frame.ok());
    const cv::Mat& ignored = frame->images->ignored;
    ASSERT_EQ(ignored.type(), CV_8UC1);
    EXPECT_EQ(cv::countNonZero(ignored), 20 * 30);
    EXPECT_NE(ignored.at<uint8_t>(3, 3), 0);
  }
}

TEST_F(MaskedDatasetTest, EndingsInCapitalsAndBehindTheWholeNameAreFound) {
  WriteMask("picture0.jpg.png", LeftHalf());
  WriteMask("picture0.png", cv::Mat(30, 40, CV_8UC1, cv::Scalar(0)));
  WriteMask("picture1.PNG", LeftHalf());
  const auto masked = MaskedDataset::Open(source_, folder_.Path(""));
  ASSERT_TRUE(masked.ok()) << masked.error().message;
  for (size_t i = 0; i < 2; ++i) EXPECT_EQ(cv::countNonZero((*masked)->Load(i)->images->ignored), 20 * 30) << i;
}

TEST_F(MaskedDatasetTest, OneFileServesAllFrames) {
  WriteMask("robot.png", LeftHalf(CV_16UC1));
  const auto masked = MaskedDataset::Open(source_, folder_.Path("robot.png"));
  ASSERT_TRUE(masked.ok());
  EXPECT_EQ(cv::countNonZero((*masked)->Load(1)->images->ignored), 20 * 30);
}

TEST_F(MaskedDatasetTest, WhatCannotBeUsedIsRefused) {
  EXPECT_THAT(MaskedDataset::Open(source_, folder_.Path("nowhere")).error().message, HasSubstr("no file or folder"));
  WriteMask("other.png", LeftHalf());
  EXPECT_THAT(MaskedDataset::Open(source_, folder_.Path("")).error().message, HasSubstr("picture0.png"));
  WriteMask("picture1.png", cv::Mat(15, 20, CV_8UC1, cv::Scalar(1)));
  const auto masked = MaskedDataset::Open(source_, folder_.Path(""));
  ASSERT_TRUE(masked.ok());
  EXPECT_TRUE((*masked)->Load(0)->images->ignored.empty());
  EXPECT_THAT((*masked)->Load(1).error().message, HasSubstr("20x15"));
}

}  // namespace
}  // namespace yorb

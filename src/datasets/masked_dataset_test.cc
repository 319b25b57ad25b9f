// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/masked_dataset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

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
  void SetSize(int width, int height) { rig_.camera.width = width, rig_.camera.height = height; }
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

TEST_F(MaskedDatasetTest, StampsThatAreCutOrRoundedAreFoundAndOthersNot) {
  WriteMask("1.4991.png", LeftHalf());
  WriteMask("1.5009.png", cv::Mat(30, 40, CV_8UC1, cv::Scalar(0)));
  WriteMask("1.49905.png", cv::Mat(30, 40, CV_8UC1, cv::Scalar(0)));
  WriteMask("3.001.png", LeftHalf());
  const auto masked = MaskedDataset::Open(source_, folder_.Path(""));
  ASSERT_TRUE(masked.ok()) << masked.error().message;
  EXPECT_EQ(cv::countNonZero((*masked)->Load(0)->images->ignored), 20 * 30) << "the nearest, of equals the first";
  EXPECT_TRUE((*masked)->Load(1)->images->ignored.empty()) << "a millisecond off is another picture";
}

TEST_F(MaskedDatasetTest, NegativesAreToldOf) {
  const auto warning = [&](const std::string& masks) {
    testing::internal::CaptureStderr();
    EXPECT_TRUE(MaskedDataset::Open(source_, folder_.Path(masks)).ok());
    return testing::internal::GetCapturedStderr();
  };
  for (const char* name : {"picture0.png", "picture1.png"}) WriteMask(name, LeftHalf() == 0);
  EXPECT_EQ(warning(""), "") << "half of it";
  cv::Mat most(30, 40, CV_8UC1, cv::Scalar(255));
  most.colRange(0, 4).setTo(0);
  WriteMask("picture1.png", most);
  EXPECT_EQ(warning(""), "") << "one picture may be full of people";
  WriteMask("picture0.png", most);
  EXPECT_THAT(warning(""), HasSubstr("take away 90 % of a picture"));
  EXPECT_THAT(warning("picture0.png"), HasSubstr("negatives"));
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

TEST_F(MaskedDatasetTest, AMaskThatCannotBeReadLeavesItsFrameWhole) {
  WriteMask("picture0.png", LeftHalf());
  WriteMask("picture1.png", LeftHalf());
  const std::string whole = folder_.Read("picture1.png");
  folder_.Write("picture1.png", whole.substr(0, whole.size() / 2));
  const auto masked = MaskedDataset::Open(source_, folder_.Path(""));
  ASSERT_TRUE(masked.ok()) << masked.error().message;
  EXPECT_EQ((*masked)->Load(0)->num_skipped, 0);
  testing::internal::CaptureStderr();
  const auto frame = (*masked)->Load(1);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("picture1.png is cut short"));
  ASSERT_TRUE(frame.ok());
  ASSERT_TRUE(frame->images);
  EXPECT_TRUE(frame->images->ignored.empty());
  EXPECT_EQ(frame->num_skipped, 1);
}

TEST_F(MaskedDatasetTest, MasksOfWhichNoneCanBeReadAreRefused) {
  folder_.Write("picture0.png", "version https://git-lfs.github.com/spec/v1");
  folder_.Write("picture1.png", "");
  for (const char* name : {"", "picture0.png"})
    EXPECT_THAT(MaskedDataset::Open(source_, folder_.Path(name)).error().message, HasSubstr("LFS")) << name;
}

TEST_F(MaskedDatasetTest, TransparencyDoesNotMask) {
  cv::Mat drawn(30, 40, CV_8UC4, cv::Scalar(0, 0, 0, 255)), in_transparency(30, 40, CV_8UC4, cv::Scalar::all(0));
  drawn.colRange(0, 20).setTo(cv::Scalar(0, 0, 9, 255));
  in_transparency.colRange(0, 20).setTo(cv::Scalar(0, 0, 0, 255));
  WriteMask("picture0.png", drawn);
  WriteMask("picture1.png", in_transparency);
  const auto masked = MaskedDataset::Open(source_, folder_.Path(""));
  ASSERT_TRUE(masked.ok()) << masked.error().message;
  EXPECT_EQ(cv::countNonZero((*masked)->Load(0)->images->ignored), 20 * 30);
  testing::internal::CaptureStderr();
  EXPECT_EQ(cv::countNonZero((*masked)->Load(1)->images->ignored), 0);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("picture1.png is black all over"));
}

TEST_F(MaskedDatasetTest, APaletteCountsByItsColours) {
  // 40 x 30, one bit a pixel: the left half 0, the right half 1; 0 is dark red and 1 black, as quantisers may have it.
  const unsigned char png[] = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
      0x00, 0x28, 0x00, 0x00, 0x00, 0x1e, 0x01, 0x03, 0x00, 0x00, 0x00, 0x64, 0x13, 0xce, 0x9e, 0x00, 0x00, 0x00,
      0x06, 0x50, 0x4c, 0x54, 0x45, 0x28, 0x00, 0x00, 0x00, 0x00, 0x00, 0x4e, 0x98, 0x3e, 0x94, 0x00, 0x00, 0x00,
      0x01, 0x74, 0x52, 0x4e, 0x53, 0x00, 0x40, 0xe6, 0xd8, 0x66, 0x00, 0x00, 0x00, 0x11, 0x49, 0x44, 0x41, 0x54,
      0x78, 0xda, 0x63, 0x60, 0x60, 0xe0, 0xff, 0xff, 0x9f, 0x61, 0x48, 0x91, 0x00, 0x49, 0x65, 0x3d, 0x87, 0xe8,
      0x04, 0x6e, 0x4a, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  folder_.Write("palette.png", std::string(reinterpret_cast<const char*>(png), sizeof(png)));
  const auto masked = MaskedDataset::Open(source_, folder_.Path("palette.png"));
  ASSERT_TRUE(masked.ok()) << masked.error().message;
  const cv::Mat ignored = (*masked)->Load(0)->images->ignored;
  EXPECT_EQ(cv::countNonZero(ignored), 20 * 30);
  EXPECT_NE(ignored.at<uint8_t>(3, 3), 0);
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
  source_.SetSize(40, 30);
  EXPECT_THAT(MaskedDataset::Open(source_, folder_.Path("")).error().message, HasSubstr("20x15")) << "before any work";
  std::filesystem::create_directories(folder_.Path("jpegs"));
  EXPECT_THAT(MaskedDataset::Open(source_, folder_.Path("jpegs")).error().message, HasSubstr("holds no PNG"));
  folder_.WritePicture("jpegs/picture0.jpg", LeftHalf());
  EXPECT_THAT(MaskedDataset::Open(source_, folder_.Path("jpegs")).error().message,
              HasSubstr("no PNG but 1 of other formats"));
}

}  // namespace
}  // namespace yorb

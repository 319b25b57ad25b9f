// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <jpeglib.h>
#include <sys/stat.h>

#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "pictures/endings.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

using ::testing::HasSubstr;

TEST(PictureFile, WholePicturesAreReadAsStored) {
  const TestFolder folder;
  folder.WritePicture("c.png", TestColour(1));
  folder.WritePicture("d.png", TestDepth(1234));
  ASSERT_TRUE(cv::imwrite(folder.Path("f.tiff"), cv::Mat(4, 6, CV_32FC1, cv::Scalar(1.5))));
  for (const char* name : {"c.png", "d.png", "f.tiff"}) EXPECT_EQ(ReadPictureFile(folder.Path(name)).fault, "") << name;
  EXPECT_EQ(cv::norm(ReadPictureFile(folder.Path("c.png")).pixels, TestColour(1), cv::NORM_INF), 0);
  EXPECT_EQ(ReadPictureFile(folder.Path("d.png")).pixels.at<uint16_t>(3, 3), 1234);
  EXPECT_EQ(ReadPictureFile(folder.Path("f.tiff")).pixels.at<float>(3, 3), 1.5f);
}

TEST(PictureFile, CutFilesAreFoundWhereverTheyAreCut) {
  const TestFolder folder;
  for (const std::string name : {"c.jpg", "c.png", "d.png"}) {
    folder.WritePicture(name, name == "d.png" ? TestDepth(777) : TestColour(1, 200, 150));
    const std::string whole = folder.Read(name);
    EXPECT_EQ(FaultOfPictureBytes(whole), "") << name;
    EXPECT_EQ(FaultOfPictureBytes(whole + std::string(100, '\0')), "") << name << " with a tail is whole";
    for (const size_t size : {size_t{0}, size_t{3}, whole.size() / 10, whole.size() / 2, whole.size() - 2}) {
      folder.Write("cut_" + name, whole.substr(0, size));
      const StoredPicture cut = ReadPictureFile(folder.Path("cut_" + name));
      EXPECT_NE(cut.fault, "") << name << " cut to " << size << " of " << whole.size();
      EXPECT_TRUE(cut.pixels.empty());
    }
    folder.Write("zeroed_" + name,
                 whole.substr(0, whole.size() / 2) + std::string(whole.size() - whole.size() / 2, '\0'));
    EXPECT_NE(ReadPictureFile(folder.Path("zeroed_" + name)).fault, "") << name << " with its second half lost";
  }
}

TEST(PictureFile, ADamagedPngIsNotHalfRead) {
  const TestFolder folder;
  folder.WritePicture("c.png", TestColour(1, 200, 150));
  std::string bytes = folder.Read("c.png");
  bytes.replace(bytes.size() / 2, 16, 16, '\x55');
  folder.Write("c.png", bytes);
  EXPECT_NE(ReadPictureFile(folder.Path("c.png")).fault, "");
}

TEST(PictureFile, JpegsAreTheBitsThatOpenCvGives) {
  const TestFolder folder;
  cv::Mat grey, odd = TestColour(3, 201, 151);
  cv::cvtColor(TestColour(2, 200, 150), grey, cv::COLOR_BGR2GRAY);
  cv::GaussianBlur(odd, odd, {5, 5}, 1.5);
  const std::pair<cv::Mat, std::vector<int>> pictures[] = {
      {grey, {}},
      {odd, {cv::IMWRITE_JPEG_QUALITY, 60}},
      {odd, {cv::IMWRITE_JPEG_PROGRESSIVE, 1}},
      {odd, {cv::IMWRITE_JPEG_RST_INTERVAL, 4}},
  };
  for (const auto& [picture, options] : pictures) {
    ASSERT_TRUE(cv::imwrite(folder.Path("c.jpg"), picture, options));
    const StoredPicture read = ReadPictureFile(folder.Path("c.jpg"));
    ASSERT_EQ(read.fault, "");
    const cv::Mat theirs = cv::imread(folder.Path("c.jpg"), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(read.pixels.type(), theirs.type());
    EXPECT_EQ(cv::norm(read.pixels, theirs, cv::NORM_INF), 0);
  }
}

TEST(PictureFile, TheJpegsWeWriteAreTheBytesThatOpenCvWrites) {
  cv::Mat colour = TestColour(3, 201, 151), grey;
  cv::GaussianBlur(colour, colour, {5, 5}, 1.5);
  cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
  for (const cv::Mat& picture : {colour, grey}) {
    std::vector<unsigned char> theirs;
    ASSERT_TRUE(cv::imencode(".jpg", picture, theirs, {cv::IMWRITE_JPEG_QUALITY, 90}));
    EXPECT_EQ(*EncodePictureFor("a.JPG", picture, 90), std::string(theirs.begin(), theirs.end()));
  }
  const auto refused = EncodePictureFor("depth.jpg", TestDepth());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("depth.jpg"));
}

TEST(PictureFile, OtherFormatsAreReadByTheModule) {
  const TestFolder folder;
  const cv::Mat picture = TestColour(4);
  for (const char* name : {"a.bmp", "a.tiff", "a.webp", "a.ppm"}) {
    ASSERT_TRUE(cv::imwrite(folder.Path(name), picture, {cv::IMWRITE_WEBP_QUALITY, 101}));
    const StoredPicture read = ReadPictureFile(folder.Path(name));
    ASSERT_EQ(read.fault, "") << name;
    EXPECT_EQ(cv::norm(read.pixels, picture, cv::NORM_INF), 0) << name;
  }
}

/// As printers and picture editors write them: four inks, the other way round (255 is no ink), in Adobe's manner.
std::string CmykJpeg(const cv::Mat& inks_left) {
  jpeg_error_mgr errors{};
  jpeg_compress_struct info{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &bytes, &size);
  info.image_width = static_cast<JDIMENSION>(inks_left.cols);
  info.image_height = static_cast<JDIMENSION>(inks_left.rows);
  info.input_components = 4;
  info.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 100, TRUE);
  jpeg_start_compress(&info, TRUE);
  for (int y = 0; y < inks_left.rows; ++y) {
    JSAMPROW row = const_cast<JSAMPROW>(inks_left.ptr(y));
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  const std::string jpeg(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&info);
  std::free(bytes);
  return jpeg;
}

TEST(PictureFile, JpegsOfFourInksHaveTheirColours) {
  const TestFolder folder;
  struct Case {
    cv::Scalar inks_left, bgr;  // cyan, magenta, yellow, black
  };
  for (const Case& c : {Case{{255, 0, 0, 255}, {0, 0, 255}}, Case{{0, 255, 0, 255}, {0, 255, 0}},
                        Case{{0, 0, 255, 255}, {255, 0, 0}}, Case{{255, 255, 255, 255}, {255, 255, 255}},
                        Case{{255, 255, 255, 0}, {0, 0, 0}}, Case{{200, 120, 40, 128}, {20, 60, 100}}}) {
    folder.Write("a.jpg", CmykJpeg(cv::Mat(16, 16, CV_8UC4, c.inks_left)));
    const StoredPicture read = ReadPictureFile(folder.Path("a.jpg"));
    ASSERT_EQ(read.fault, "");
    ASSERT_EQ(read.pixels.type(), CV_8UC3);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(read.pixels.at<cv::Vec3b>(8, 8)[k], c.bgr[k], 4) << c.inks_left;
  }
  const std::string whole = folder.Read("a.jpg");
  folder.Write("a.jpg", whole.substr(0, whole.size() - 40));
  EXPECT_EQ(ReadPictureFile(folder.Path("a.jpg")).fault, "is cut short");
}

TEST(PictureFile, JpegsThatMakeNoSenseInTheirMiddleAreDamagedAndStrayBytesAreNot) {
  const TestFolder folder;
  cv::Mat picture = TestColour(1, 200, 150);
  ASSERT_TRUE(cv::imwrite(folder.Path("c.jpg"), picture, {cv::IMWRITE_JPEG_QUALITY, 80}));
  const std::string whole = folder.Read("c.jpg");
  const auto fault_of = [&](const std::string& bytes) {
    folder.Write("bad.jpg", bytes);
    const StoredPicture read = ReadPictureFile(folder.Path("bad.jpg"));
    EXPECT_EQ(read.pixels.empty(), !read.fault.empty());
    return read.fault;
  };
  std::string garbled = whole, short_data = whole, stray = whole;
  garbled.replace(whole.size() / 2, 400, 400, '\x55');
  short_data.erase(whole.size() - 502, 500);
  stray.insert(whole.size() - 2, "\x12\x34\x56");
  EXPECT_EQ(fault_of(garbled), "is damaged");
  EXPECT_EQ(fault_of(short_data), "is damaged");
  EXPECT_EQ(fault_of(stray), "");
}

TEST(PictureFile, ThePreviewInAJpegsHeaderDoesNotCountAsItsEnd) {
  const TestFolder folder;
  folder.WritePicture("c.jpg", TestColour(1, 200, 150));
  folder.WritePicture("preview.jpg", TestColour(2, 20, 15));
  const std::string whole = folder.Read("c.jpg"), preview = "Exif" + folder.Read("preview.jpg");
  const size_t length = preview.size() + 2;
  std::string with_preview = whole.substr(0, 2) + "\xff\xe1" + static_cast<char>(length >> 8) +
                             static_cast<char>(length & 255) + preview + whole.substr(2);
  EXPECT_EQ(FaultOfPictureBytes(with_preview), "");
  EXPECT_NE(FaultOfPictureBytes(with_preview.substr(0, with_preview.size() / 2 + preview.size() / 2)), "");
}

TEST(PictureFile, WhatIsNoPictureIsSaid) {
  const TestFolder folder;
  folder.Write("text.png", "not a picture at all");
  folder.Write("lfs.png", "version https://git-lfs.github.com/spec/v1\noid sha256:00\n");
  EXPECT_THAT(ReadPictureFile(folder.Path("text.png")).fault, HasSubstr("decoded"));
  EXPECT_THAT(ReadPictureFile(folder.Path("lfs.png")).fault, HasSubstr("LFS"));
  EXPECT_THAT(ReadPictureFile(folder.Path("gone.png")).fault, HasSubstr("opened"));
  EXPECT_NE(ReadPictureFile(folder.Path()).fault, "");
  folder.Write("phone.heic", std::string("\0\0\0\x18"
                                         "ftypheic\0\0\0\0mif1heic",
                                         24) +
                                 std::string(100, '\0'));
  EXPECT_THAT(ReadPictureFile(folder.Path("phone.heic")).fault, HasSubstr("HEIC"));
  EXPECT_TRUE(HasPictureEnding("phone.HEIC")) << "so that it is named where a folder is read";
  EXPECT_TRUE(HasPictureEnding("saved.jfif"));
  ASSERT_EQ(::mkfifo(folder.Path("pipe.png").c_str(), 0600), 0);
  EXPECT_THAT(ReadPictureFile(folder.Path("pipe.png")).fault, HasSubstr("regular"));
}

TEST(ColourAndGrey, EveryUsualKindIsTheSamePicture) {
  const cv::Mat bgr = TestColour(3);
  cv::Mat bgra, grey, bgr16, grey16;
  cv::cvtColor(bgr, bgra, cv::COLOR_BGR2BGRA);
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  bgr.convertTo(bgr16, CV_16U, 257);
  grey.convertTo(grey16, CV_16U, 257);
  for (const cv::Mat& stored : {bgr, bgra, bgr16}) {
    const auto picture = ToColourAndGrey(stored, "a.png");
    ASSERT_TRUE(picture.ok());
    EXPECT_EQ(cv::norm(picture->colour, bgr, cv::NORM_INF), 0);
    EXPECT_EQ(cv::norm(picture->grey, grey, cv::NORM_INF), 0);
  }
  for (const cv::Mat& stored : {grey, grey16}) {
    const auto picture = ToColourAndGrey(stored, "a.png");
    ASSERT_TRUE(picture.ok());
    EXPECT_TRUE(picture->colour.empty());
    EXPECT_EQ(cv::norm(picture->grey, grey, cv::NORM_INF), 0);
  }
  const auto floats = ToColourAndGrey(cv::Mat(4, 4, CV_32FC3), "a.tiff");
  ASSERT_FALSE(floats.ok());
  EXPECT_THAT(floats.error().message, HasSubstr("a.tiff"));
}

TEST(ColourAndGrey, SixteenBitsOfWhichASensorUsesFewerAreNoBlackPicture) {
  const cv::Mat bgr = TestColour(3);
  cv::Mat grey;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  grey.at<uint8_t>(0, 0) = 255;
  for (const int bits : {8, 10, 12, 14, 16}) {
    const double scale = ((1 << bits) - 1) / 255.0;
    cv::Mat stored, colour, transparent;
    grey.convertTo(stored, CV_16U, scale);
    bgr.convertTo(colour, CV_16U, scale);
    cv::cvtColor(colour, transparent, cv::COLOR_BGR2BGRA);  // opaque: 65535
    EXPECT_EQ(UsedBits(stored), bits);
    EXPECT_EQ(UsedBits(transparent), bits);
    EXPECT_LE(cv::norm(ToColourAndGrey(stored, "a.png")->grey, grey, cv::NORM_INF), 1) << bits;
    EXPECT_LE(cv::norm(ToColourAndGrey(transparent, "a.png")->colour, bgr, cv::NORM_INF), 1) << bits;
  }
  const cv::Mat dark(4, 4, CV_16UC1, cv::Scalar(512));
  EXPECT_EQ(ToColourAndGrey(dark, "a.png", 12)->grey.at<uint8_t>(0, 0), 32) << "as the other pictures of its recording";
}

TEST(Depth, OnlyDepthOfTheColourPicturesSizeIsTaken) {
  EXPECT_TRUE(CheckDepth(cv::Mat(4, 6, CV_16UC1), {6, 4}, "d.png").ok());
  EXPECT_TRUE(CheckDepth(cv::Mat(4, 6, CV_32FC1), {6, 4}, "d.png").ok());
  for (const int type : {CV_8UC1, CV_8UC3, CV_16UC3, CV_32FC3, CV_64FC1, CV_16SC1}) {
    const Status wrong = CheckDepth(cv::Mat(4, 6, type), {6, 4}, "d.png");
    ASSERT_FALSE(wrong.ok()) << type;
    EXPECT_THAT(wrong.error().message, HasSubstr("d.png"));
  }
  EXPECT_THAT(CheckDepth(cv::Mat(2, 3, CV_16UC1), {6, 4}, "d.png").error().message, HasSubstr("3x2"));
}

}  // namespace
}  // namespace yorb

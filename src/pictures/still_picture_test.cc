// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/still_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "pictures/endings.h"
#include "pictures/exif.h"
#include "pictures/jpeg.h"
#include "pictures/picture_folder.h"
#include "pictures/test_folder.h"
#include "pictures/video.h"

namespace yorb {
namespace {

/// An EXIF block that says nothing but the orientation.
std::string Exif(int orientation, bool is_little) {
  const auto number = [&](unsigned value, int size) {
    std::string bytes;
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * (is_little ? i : size - 1 - i));
    return bytes;
  };
  return (is_little ? "II" : "MM") + number(42, 2) + number(8, 4) + number(1, 2) + number(0x112, 2) + number(3, 2) +
         number(1, 4) + number(static_cast<unsigned>(orientation), 2) + number(0, 2) + number(0, 4);
}

/// A JPEG with that block behind its start.
std::string JpegWith(const cv::Mat& picture, const std::string& exif) {
  const std::string bytes = *EncodeJpeg(picture, 100);
  const std::string segment = std::string("Exif\0\0", 6) + exif;
  const size_t length = segment.size() + 2;
  const std::string head{'\xff', '\xe1', static_cast<char>(length >> 8), static_cast<char>(length)};
  return bytes.substr(0, 2) + head + segment + bytes.substr(2);
}

/// 40 wide, 20 high; white in the corner at the top left, grey else.
cv::Mat Cornered() {
  cv::Mat picture(20, 40, CV_8UC3, cv::Scalar::all(60));
  picture(cv::Rect(0, 0, 12, 8)).setTo(cv::Scalar::all(255));
  return picture;
}

TEST(StillPicture, IsTurnedAsViewersShowIt) {
  const TestFolder folder;
  // Where the corner of the stored picture comes to lie, as the EXIF standard defines the eight orientations.
  struct Case {
    int orientation;
    bool is_tall, is_right, is_bottom;
  };
  for (const Case& c : {Case{1, false, false, false}, Case{2, false, true, false}, Case{3, false, true, true},
                        Case{4, false, false, true}, Case{5, true, false, false}, Case{6, true, true, false},
                        Case{7, true, true, true}, Case{8, true, false, true}}) {
    for (const bool is_little : {true, false}) {
      folder.Write("a.jpg", JpegWith(Cornered(), Exif(c.orientation, is_little)));
      const auto picture = ReadUprightPicture(folder.Path("a.jpg"));
      ASSERT_TRUE(picture) << picture.error().message;
      EXPECT_EQ(picture->size(), c.is_tall ? cv::Size(20, 40) : cv::Size(40, 20)) << c.orientation;
      const int x = c.is_right ? picture->cols - 3 : 2, y = c.is_bottom ? picture->rows - 3 : 2;
      EXPECT_GT(picture->at<cv::Vec3b>(y, x)[0], 200) << c.orientation;
    }
  }
}

/// A WebP without loss, with that block behind its picture.
std::string WebpWith(const cv::Mat& picture, const std::string& block) {
  std::vector<unsigned char> written;
  EXPECT_TRUE(cv::imencode(".webp", picture, written, {cv::IMWRITE_WEBP_QUALITY, 101}));
  const std::string simple(written.begin(), written.end());
  const auto number = [](size_t value, int size) {
    std::string bytes;
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * i);
    return bytes;
  };
  const auto chunk = [&](const std::string& name, const std::string& content) {
    return name + number(content.size(), 4) + content + std::string(content.size() % 2, '\0');
  };
  const std::string features = '\x08' + number(0, 3) + number(static_cast<size_t>(picture.cols) - 1, 3) +
                               number(static_cast<size_t>(picture.rows) - 1, 3);
  const std::string content = "WEBP" + chunk("VP8X", features) + simple.substr(12) + chunk("EXIF", block);
  return "RIFF" + number(content.size(), 4) + content;
}

TEST(StillPicture, WebpIsTurned) {
  const TestFolder folder;
  for (const std::string& mark : {std::string(), std::string("Exif\0\0", 6)}) {
    folder.Write("a.webp", WebpWith(Cornered(), mark + Exif(6, false)));
    const auto picture = ReadUprightPicture(folder.Path("a.webp"));
    ASSERT_TRUE(picture) << picture.error().message;
    ASSERT_EQ(picture->size(), cv::Size(20, 40));
    EXPECT_GT(picture->at<cv::Vec3b>(2, 17)[0], 200);
    const std::string whole = folder.Read("a.webp");
    for (size_t size = 0; size < whole.size(); ++size) ExifOrientation(whole.substr(0, size));
  }
}

TEST(StillPicture, DamagedExifIsUpright) {
  EXPECT_EQ(ExifOrientation(""), 1);
  EXPECT_EQ(ExifOrientation("\xff\xd8\xff\xe1"), 1);
  const std::string jpeg = JpegWith(Cornered(), Exif(9, true));
  EXPECT_EQ(ExifOrientation(jpeg), 1);
  for (size_t size = 0; size < 60; ++size) ExifOrientation(JpegWith(Cornered(), Exif(6, true)).substr(0, size));
  const std::string png = std::string(
                              "\x89PNG\r\n\x1a\n\0\0\0\x1a"
                              "eXIf",
                              16) +
                          Exif(8, false) + "CRC.";
  EXPECT_EQ(ExifOrientation(png), 8);
}

TEST(StillPicture, WhatCannotBeReadIsNamed) {
  const TestFolder folder;
  folder.Write("text.png", "no picture");
  for (const char* name : {"gone.png", "text.png"}) {
    const auto picture = ReadUprightPicture(folder.Path(name));
    ASSERT_FALSE(picture);
    EXPECT_THAT(picture.error().message, testing::HasSubstr(name));
  }
}

TEST(PictureFolder, FollowsLinksOnceAndPassesOverHiddenOnes) {
  const TestFolder folder, elsewhere;
  folder.WritePicture("set/b/2.png", TestColour(0));
  folder.WritePicture("set/a.PNG", TestColour(0));
  folder.WritePicture("set/.hidden/x.png", TestColour(0));
  folder.Write("set/notes.txt", "no picture");
  elsewhere.WritePicture("3.jpg", TestColour(0));
  std::filesystem::create_directory_symlink(elsewhere.Path(), folder.Path("set/link"));
  std::filesystem::create_directory_symlink(folder.Path("set"), folder.Path("set/b/loop"));
  const std::vector<std::string> wanted{folder.Path("set/a.PNG"), folder.Path("set/b/2.png"),
                                        folder.Path("set/link/3.jpg")};
  EXPECT_EQ(PicturesUnder(folder.Path("set")), wanted);
}

TEST(PictureFolder, NumbersInNamesCountByTheirValue) {
  const TestFolder folder;
  const std::vector<std::string> wanted{"0.25.png",
                                        "0.3.png",
                                        "01.png",
                                        "1.png",
                                        "2.png",
                                        "10.png",
                                        "10b.png",
                                        "a2b2.png",
                                        "a2b10.png",
                                        "a010b1.png",
                                        "a99999999999999999999.png"};
  for (const std::string& name : wanted) folder.WritePicture(name, TestColour(0));
  std::vector<std::string> names;
  for (const std::string& path : PicturesIn(folder.Path("")))
    names.push_back(std::filesystem::path(path).filename().string());
  EXPECT_EQ(names, wanted);
}

TEST(Video, IsReadPictureByPicture) {
  const TestFolder folder;
  {
    cv::VideoWriter writer(folder.Path("clip.avi"), cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                           10, {64, 48});
    ASSERT_TRUE(writer.isOpened());
    for (int i = 0; i < 4; ++i) writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(50 * i)));
  }
  auto video = Video::Open(folder.Path("clip.avi"));
  ASSERT_TRUE(video) << video.error().message;
  double last = -1;
  for (int i = 0; i < 4; ++i) {
    const auto frame = video->Next();
    ASSERT_TRUE(frame) << i;
    EXPECT_NEAR(frame->bgr.at<cv::Vec3b>(24, 32)[0], 50 * i, 6);
    EXPECT_GT(frame->time.seconds(), last);
    last = frame->time.seconds();
  }
  EXPECT_FALSE(video->Next());
  EXPECT_EQ(video->Shortfall(), "");
  for (const char* name : {"a.MP4", "a.3gp", "00001.MTS"}) EXPECT_TRUE(HasVideoEnding(name)) << name;
  EXPECT_FALSE(HasVideoEnding("a.png"));
  EXPECT_FALSE(Video::Open(folder.Path("gone.mp4")));
}

TEST(Video, ThatEndsBeforeItSaysTellsHowMuchIsMissing) {
  const TestFolder folder;
  constexpr int kNumPictures = 40;
  {
    cv::VideoWriter writer(folder.Path("clip.avi"), cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                           10, {64, 48});
    ASSERT_TRUE(writer.isOpened());
    for (int i = 0; i < kNumPictures; ++i) writer.write(TestColour(i));
  }
  const std::string whole = folder.Read("clip.avi");
  folder.Write("clip.avi", whole.substr(0, whole.size() / 2));
  auto video = Video::Open(folder.Path("clip.avi"));
  ASSERT_TRUE(video) << video.error().message;
  int num_read = 0;
  while (video->Next()) ++num_read;
  ASSERT_LT(num_read, kNumPictures);
  EXPECT_EQ(video->Shortfall(),
            "says that it holds 40 pictures, of which " + std::to_string(num_read) + " can be read; is it cut short?");
}

}  // namespace
}  // namespace yorb

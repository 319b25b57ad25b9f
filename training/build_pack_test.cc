// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/build_pack.h"

#include <gtest/gtest.h>

#include "pictures/test_folder.h"
#include "training/pack.h"

namespace yorb {
namespace {

const auto kSilent = [](size_t) {};

cv::Mat Grey(int width, int height) { return cv::Mat(height, width, CV_8UC3, cv::Scalar::all(90)); }

TEST(BuildPack, PicturesOfLabelImgArePackedWithTheirLabels) {
  const TestFolder folder;
  folder.Write("classes.txt", "cup\nfork\n");
  folder.WritePicture("a.png", Grey(640, 320));
  folder.Write("a.txt", "1 0.5 0.5 0.25 0.5\n");
  folder.WritePicture("b.jpg", Grey(100, 50));
  folder.Write("b.xml",
               "<annotation><size><width>100</width><height>50</height></size><object><name>cup</name><bndbox>"
               "<xmin>0</xmin><ymin>0</ymin><xmax>50</xmax><ymax>50</ymax></bndbox></object></annotation>");
  folder.WritePicture("c.png", Grey(32, 32));  // nothing in it
  const auto files = FindLabelledFiles(folder.Path());
  ASSERT_TRUE(files.ok()) << files.error().message;
  const auto list = FindClassList(folder.Path());
  ASSERT_TRUE(list.ok());
  const auto counts = BuildPack(*files, folder.Path("set.pack"), {.class_list = *list}, kSilent);
  ASSERT_TRUE(counts.ok()) << counts.error().message;
  EXPECT_EQ(counts->num_pictures, 3u);
  EXPECT_EQ(counts->num_boxes, 2u);
  const auto pack = Pack::Open(folder.Path("set.pack"));
  ASSERT_TRUE(pack.ok());
  EXPECT_EQ((*pack)->Get(0).pixels.size(), cv::Size(320, 160));  // reduced to the longer side
  EXPECT_EQ((*pack)->Get(1).pixels.size(), cv::Size(100, 50));   // never enlarged
  EXPECT_EQ((*pack)->Get(0).boxes[0].class_index, 1);
  EXPECT_NEAR((*pack)->Get(1).boxes[0].cx, 0.25, 1e-6);
}

TEST(BuildPack, ATeachersDoubtsAreKeptWhereNothingIsKnown) {
  const TestFolder folder;
  folder.Write("classes.txt", "person\n");
  folder.WritePicture("images/set/a.png", Grey(64, 64));
  folder.Write("labels/set/a.txt", "0 0.25 0.5 0.2 0.4\n");
  // One is the known person again, one is somebody else, one is sure but was left out by whoever made the labels.
  folder.Write("teacher/a.txt", "0 0.25 0.5 0.2 0.38 0.3\n0 0.75 0.5 0.2 0.4 0.3\n0 0.5 0.5 0.2 0.4 0.9\n");
  const auto files = FindLabelledFiles(folder.Path("images/set"));
  ASSERT_TRUE(files.ok());
  const BuildPackOptions options{.class_list = folder.Path("classes.txt"), .teacher = folder.Path("teacher")};
  const auto counts = BuildPack(*files, folder.Path("set.pack"), options, kSilent);
  ASSERT_TRUE(counts.ok()) << counts.error().message;
  EXPECT_EQ(counts->num_boxes, 1u);
  EXPECT_EQ(counts->num_doubtful, 1u);
}

TEST(BuildPack, PicturesThatCannotBeReadAreNamed) {
  const TestFolder folder;
  folder.Write("classes.txt", "person\n");
  folder.Write("a.jpg", "no picture");
  const auto files = FindLabelledFiles(folder.Path());
  ASSERT_TRUE(files.ok());
  const auto counts = BuildPack(*files, folder.Path("set.pack"), {.class_list = folder.Path("classes.txt")}, kSilent);
  ASSERT_FALSE(counts.ok());
  EXPECT_NE(counts.error().message.find("a.jpg"), std::string::npos);
  EXPECT_FALSE(FindLabelledFiles(folder.Path("none")).ok());
}

}  // namespace
}  // namespace yorb

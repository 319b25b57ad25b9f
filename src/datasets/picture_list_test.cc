// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/picture_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/associations.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

using ::testing::HasSubstr;

class Lists : public ::testing::Test {
 protected:
  PictureList ReadList(const std::string& content) {
    folder_.Write("rgb.txt", content);
    auto list = ReadPictureList(folder_.Path("rgb.txt"));
    EXPECT_TRUE(list.ok()) << (list.ok() ? "" : list.error().message);
    return list.ok() ? *list : PictureList();
  }
  std::string ListComplaint(const std::string& content) {
    folder_.Write("rgb.txt", content);
    const auto list = ReadPictureList(folder_.Path("rgb.txt"));
    if (!list) return list.error().message;
    const Status stamps = CheckStamps(*list);
    EXPECT_FALSE(stamps.ok()) << "accepted:\n" << content;
    return stamps.ok() ? "" : stamps.error().message;
  }
  Associations ReadPairs(const std::string& content) {
    folder_.Write("associations.txt", content);
    auto pairs = ReadAssociations(folder_.Path("associations.txt"));
    EXPECT_TRUE(pairs.ok()) << (pairs.ok() ? "" : pairs.error().message);
    return pairs.ok() ? *pairs : Associations();
  }
  std::string PairsComplaint(const std::string& content) {
    folder_.Write("associations.txt", content);
    const auto pairs = ReadAssociations(folder_.Path("associations.txt"));
    EXPECT_FALSE(pairs.ok()) << "accepted:\n" << content;
    return pairs.ok() ? "" : pairs.error().message;
  }

  TestFolder folder_;
};

TEST_F(Lists, EverySpellingOfALineIsTheSameLine) {
  folder_.Write("rgb/a.png", "x");
  for (const std::string line :
       {"1305031102.175304 rgb/a.png", "1305031102.175304\trgb/a.png", "  1305031102.1753040  rgb/a.png  \r",
        "1.305031102175304000e+09 rgb/a.png", "1305031102.175304,rgb/a.png", "1305031102.175304, rgb/a.png",
        "1305031102.175304 ./rgb/a.png", "1305031102.175304 \"rgb/a.png\"", "1305031102.175304 rgb\\a.png",
        "1305031102.175304 rgb/a.png 0.25 further", "\xef\xbb\xbf# remark\r\n\r\n1305031102.175304 rgb/a.png",
        "timestamp filename\n1305031102.175304 rgb/a.png", "1305031102.175304;rgb/a.png"}) {
    const auto list = ReadList(line + "\n");
    ASSERT_EQ(list.pictures.size(), 1u) << line;
    EXPECT_EQ(ToString(list.pictures[0].time), "1305031102.175304") << line;
    EXPECT_EQ(list.pictures[0].path, folder_.Path("rgb/a.png")) << line;
  }
}

TEST_F(Lists, OfPowerShellAreUtf16) {
  std::string utf16 = "\xff\xfe";
  for (const char letter : std::string("1.25 rgb/a.png\r\n1.5 rgb/b.png\r\n")) utf16 += {letter, '\0'};
  const auto list = ReadList(utf16);
  ASSERT_EQ(list.pictures.size(), 2u);
  EXPECT_EQ(list.pictures[1].name, "rgb/b.png");
}

TEST_F(Lists, NamesMayHoldBlanksAndLieAnywhere) {
  folder_.Write("rgb/picture 1 (a).jpg", "x");
  folder_.Write("far/s\xc3\xa9q.png", "x");
  const auto list =
      ReadList("1 rgb/picture 1 (a).jpg\n2 " + folder_.Path("far/s\xc3\xa9q.png") + "\n3 rgb/gone 3.png\n");
  ASSERT_EQ(list.pictures.size(), 3u);
  EXPECT_EQ(list.pictures[0].path, folder_.Path("rgb/picture 1 (a).jpg"));
  EXPECT_EQ(list.pictures[1].path, folder_.Path("far/s\xc3\xa9q.png"));
  EXPECT_EQ(list.pictures[2].path, folder_.Path("rgb/gone 3.png")) << "a missing file keeps its whole name";
  EXPECT_EQ(list.pictures[2].line, 3);
}

TEST_F(Lists, WrongLinesAreNamedByFileAndNumber) {
  EXPECT_THAT(ListComplaint("# only remarks\n"), HasSubstr("names no picture"));
  EXPECT_THAT(ListComplaint(""), HasSubstr("rgb.txt"));
  EXPECT_THAT(ListComplaint("1.0 a.png\n1.1\n"), HasSubstr("rgb.txt, line 2"));
  EXPECT_THAT(ListComplaint("1.0 a.png\nnan b.png\n"), HasSubstr("line 2"));
  EXPECT_THAT(ListComplaint("1.0 a.png\ninf b.png\n"), HasSubstr("line 2"));
  EXPECT_THAT(ListComplaint("a.png\n"), HasSubstr("line 1"));
  EXPECT_THAT(ListComplaint("1305031102,175304 rgb/a.png\n"), HasSubstr("decimal point"));
}

TEST_F(Lists, StampsMustIncreaseAndBeSeconds) {
  EXPECT_THAT(ListComplaint("1.0 a.png\n1.1 b.png\n1.1 c.png\n"), HasSubstr("rgb.txt, line 3"));
  EXPECT_THAT(ListComplaint("1.0 a.png\n1.1 b.png\n1.10 c.png\n"), HasSubstr("repeats"));
  EXPECT_THAT(ListComplaint("# x\n1.2 a.png\n1.1 b.png\n"), HasSubstr("line 3"));
  EXPECT_THAT(ListComplaint("# x\n1.2 a.png\n1.1 b.png\n"), HasSubstr("goes back"));
  EXPECT_THAT(ListComplaint("1403636579763555584 a.png\n1403636579813555456 b.png\n"), HasSubstr("nanoseconds"));
  EXPECT_THAT(ListComplaint("1403636579763 a.png\n1403636579813 b.png\n"), HasSubstr("second"));
  EXPECT_THAT(ListComplaint("1.403636579763555584e18 a.png\n"), HasSubstr("nanoseconds"));
  EXPECT_THAT(ListComplaint("1403636579763.25 a.png\n"), HasSubstr("second"));
  EXPECT_THAT(ListComplaint("0.00000001 a.png\n0.00000002 b.png\n"), HasSubstr("second"));
  EXPECT_THAT(ListComplaint("0 a.png\n33333333 b.png\n66666667 c.png\n"), HasSubstr("nanoseconds"));
  EXPECT_THAT(ListComplaint("0 a.png\n33 b.png\n67 c.png\n"), HasSubstr("count"));
  EXPECT_TRUE(CheckStamps(ReadList("0 a.png\n0.033 b.png\n3600 c.png\n3600.033 d.png\n")).ok()) << "an hour's gap";
  EXPECT_TRUE(CheckStamps(ReadList("-0.1 a.png\n0 b.png\n")).ok());
}

TEST_F(Lists, AssociationsInAnyOrderOfColumns) {
  const std::string truth = "1.31 1.35 0.63 1.66 0.61 0.59 -0.33 -0.40";
  const std::string colour = "1.25 rgb/1.25.png", depth = "1.26 depth/1.26.png";
  for (const std::string& line : {colour + " " + depth, depth + " " + colour, colour + " " + depth + " " + truth,
                                  truth + " " + depth + " " + colour, truth + "\t" + colour + "\t" + depth,
                                  std::string("1.25,rgb/1.25.png,1.26,depth/1.26.png"), depth + " 7 " + colour,
                                  std::string("1.25 \"rgb/1.25.png\" 1.26 \"depth/1.26.png\"")}) {
    const auto pairs = ReadPairs(line + "\n");
    ASSERT_EQ(pairs.colour.pictures.size(), 1u) << line;
    EXPECT_EQ(pairs.colour.pictures[0].name, "rgb/1.25.png") << line;
    EXPECT_EQ(ToString(pairs.colour.pictures[0].time), "1.250000") << line;
    EXPECT_EQ(pairs.depth.pictures[0].name, "depth/1.26.png") << line;
    EXPECT_EQ(ToString(pairs.depth.pictures[0].time), "1.260000") << line;
  }
}

TEST_F(Lists, DepthIsToldByThePartsOfTheNameThatDiffer) {
  const auto name_of_depth = [&](const std::string& line) { return ReadPairs(line + "\n").depth.pictures.at(0).name; };
  EXPECT_EQ(name_of_depth("1 /data_depth/rgb/1.png 1 /data_depth/depth/1.png"), "/data_depth/depth/1.png");
  EXPECT_EQ(name_of_depth("1 /data_depth/depth/1.png 1 /data_depth/rgb/1.png"), "/data_depth/depth/1.png");
  EXPECT_EQ(name_of_depth("1 frame-1.depth.png 1 frame-1.color.jpg"), "frame-1.depth.png");
  EXPECT_EQ(name_of_depth("1 rgb/p 1 b.png 1 Depth/p 1 b.png"), "Depth/p 1 b.png");
  folder_.WritePicture("a/1.png", TestDepth());
  folder_.WritePicture("b/1.png", TestColour(1));
  EXPECT_EQ(name_of_depth("1 a/1.png 1 b/1.png"), "a/1.png") << "told by the pictures themselves";
  folder_.WritePicture("c/1.png", TestColour(1));
  EXPECT_THAT(PairsComplaint("1 c/1.png 1 b/1.png\n"), HasSubstr("associations.txt"));
}

TEST_F(Lists, WrongAssociationsAreNamedByLine) {
  EXPECT_THAT(PairsComplaint("1 rgb/1.png 1 depth/1.png\n2 rgb/2.png\n"), HasSubstr("associations.txt, line 2"));
  EXPECT_THAT(PairsComplaint("1 rgb/1.png 1 depth/1.png 1 ir/1.png\n"), HasSubstr("line 1"));
  EXPECT_THAT(PairsComplaint("rgb/1.png depth/1.png\n"), HasSubstr("line 1"));
  EXPECT_THAT(PairsComplaint("# x\n"), HasSubstr("names no picture"));
}

}  // namespace
}  // namespace yorb

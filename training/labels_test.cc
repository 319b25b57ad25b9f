// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/labels.h"

#include <gtest/gtest.h>

#include <set>

#include "pictures/test_folder.h"
#include "training/label_rules.h"
#include "training/split.h"
#include "training/voc_labels.h"

namespace yorb {
namespace {

class LabelFiles : public testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& content) const {
    folder_.Write(name, content);
    return folder_.Path(name);
  }

  TestFolder folder_;
};

TEST_F(LabelFiles, BoxesAndPolygonsAreReadAndCutToThePicture) {
  const auto boxes = ReadYoloLabels(Write("a.txt",
                                          "1 0.5 0.5 0.2 0.4\n0 0.1 0.2 0.3 0.2 0.3 0.6 0.1 0.6\n"
                                          "2 0.95 0.5 0.2 0.2\n1 0.5 0.5 0.2 0.4\n"),
                                    3);
  ASSERT_TRUE(boxes.ok()) << boxes.error().message;
  ASSERT_EQ(boxes->size(), 3u);  // the line that stands twice counts once
  EXPECT_EQ((*boxes)[0].class_index, 1);
  EXPECT_NEAR((*boxes)[1].cx, 0.2, 1e-6);
  EXPECT_NEAR((*boxes)[1].height, 0.4, 1e-6);
  EXPECT_NEAR((*boxes)[2].cx + (*boxes)[2].width / 2, 1.0, 1e-6);
}

TEST_F(LabelFiles, AMissingFileIsAnEmptyPicture) {
  const auto boxes = ReadYoloLabels(folder_.Path("none.txt"), 3);
  ASSERT_TRUE(boxes.ok());
  EXPECT_TRUE(boxes->empty());
}

TEST_F(LabelFiles, BadLinesAreNamed) {
  for (const char* line : {"0 0.5 0.5 0.2\n", "x 0.5 0.5 0.2 0.2\n", "3 0.5 0.5 0.2 0.2\n", "0.5 0.5 0.5 0.2 0.2\n",
                           "0 nan 0.5 0.2 0.2\n"}) {
    const auto boxes = ReadYoloLabels(Write("bad.txt", std::string("0 0.5 0.5 0.1 0.1\n") + line), 3);
    ASSERT_FALSE(boxes.ok()) << line;
    EXPECT_NE(boxes.error().message.find("bad.txt, line 2"), std::string::npos) << boxes.error().message;
  }
}

TEST_F(LabelFiles, OnlyTheUnsureOnesAreKept) {
  const std::string path =
      Write("teacher.txt", "0 0.5 0.5 0.1 0.1 0.9\n0 0.5 0.5 0.1 0.1 0.3\n0 0.5 0.5 0.1 0.1 0.1\n");
  const auto boxes = ReadDoubtfulBoxes(path, 1, 0.2, 0.4);
  ASSERT_TRUE(boxes.ok());
  ASSERT_EQ(boxes->size(), 1u);
  EXPECT_EQ(boxes->front().is_doubtful, 1);
}

TEST_F(LabelFiles, ObjectsOfLabelImgAreRead) {
  const ClassTable classes{{"chair", "person"}, {"", ""}};
  const std::string path = Write("voc.xml",
                                 "<annotation><size><width>200</width><height>100</height><depth>3</depth></size>"
                                 "<object><name>person</name><difficult>0</difficult><bndbox><xmin>20</xmin>"
                                 "<ymin>10</ymin><xmax>60</xmax><ymax>90</ymax></bndbox></object>"
                                 "<object><name>Chair</name><difficult>1</difficult><bndbox><xmin>100</xmin>"
                                 "<ymin>50</ymin><xmax>220</xmax><ymax>100</ymax></bndbox></object></annotation>");
  const auto boxes = ReadVocLabels(path, classes);
  ASSERT_TRUE(boxes.ok()) << boxes.error().message;
  ASSERT_EQ(boxes->size(), 2u);
  EXPECT_EQ((*boxes)[0].class_index, 1);
  EXPECT_NEAR((*boxes)[0].cx, 0.2, 1e-6);
  EXPECT_NEAR((*boxes)[0].height, 0.8, 1e-6);
  EXPECT_NEAR((*boxes)[1].width, 0.5, 1e-6);  // cut at the picture's border
  EXPECT_EQ((*boxes)[1].is_doubtful, 1);
}

TEST_F(LabelFiles, UnknownClassesAndMissingPartsAreNamed) {
  const ClassTable classes{{"chair"}, {""}};
  const auto unknown = ReadVocLabels(
      Write("u.xml",
            "<size><width>9</width><height>9</height></size><object><name>sofa</name><bndbox></bndbox></object>"),
      classes);
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().message.find("sofa"), std::string::npos);
  EXPECT_FALSE(ReadVocLabels(Write("e.xml", "<annotation></annotation>"), classes).ok());
}

TEST_F(LabelFiles, TheFirstFittingPrefixCounts) {
  const auto rules = ReadLabelRules(Write("rules.txt", "door_ 0-2 5\nsq_ all squashed\n* 1\n"));
  ASSERT_TRUE(rules.ok()) << rules.error().message;
  const LabelRule door = RuleFor("door_17", *rules);
  EXPECT_TRUE(door.judged[2] && door.judged[5] && !door.judged[3]);
  EXPECT_TRUE(RuleFor("sq_1", *rules).is_squashed);
  EXPECT_EQ(RuleFor("other", *rules).judged.count(), 1u);
  EXPECT_TRUE(RuleFor("other", {}).judged.all());
  EXPECT_FALSE(ReadLabelRules(Write("bad_rules.txt", "a 5-2\n")).ok());
}

TEST(Split, IsSeededAndCoversAllFilesOnce) {
  std::vector<LabelledFile> files;
  for (int i = 0; i < 101; ++i) files.push_back({std::to_string(i), "", ""});
  const Split a = SplitFiles(files, {4, 1}, 7), b = SplitFiles(files, {4, 1}, 7), c = SplitFiles(files, {4, 1}, 8);
  EXPECT_EQ(a.val.size(), 20u);
  EXPECT_EQ(a.train.size(), 81u);
  const auto names = [](const Split& split) {
    std::vector<std::string> all;
    for (const auto& file : split.val) all.push_back(file.picture);
    return all;
  };
  EXPECT_EQ(names(a), names(b));
  EXPECT_NE(names(a), names(c));
  std::set<std::string> all;
  for (const auto& file : a.train) all.insert(file.picture);
  for (const auto& file : a.val) all.insert(file.picture);
  EXPECT_EQ(all.size(), files.size());
  EXPECT_FALSE(ParseSplitRatio("4:0").ok());
  EXPECT_FALSE(ParseSplitRatio("4").ok());
}

}  // namespace
}  // namespace yorb

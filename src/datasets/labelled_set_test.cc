// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labelled_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/log.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Names = std::vector<std::string>;

Result<std::vector<LabelledBox>> Labels(const std::string& text, size_t num_keypoint_numbers = 0) {
  const LabelForm form{{"person", "", "cup"}, num_keypoint_numbers};
  const TestFolder folder;
  folder.Write("a.txt", text);
  return ReadLabelFile(folder.Path("a.txt"), form);
}

TEST(LabelFile, IsReadAsPeopleHaveIt) {
  const auto boxes = Labels("\xef\xbb\xbf# note\r\n0 0.5 0.25 0.5 0.5 \r\n\r\n2\t0.5\t0.5\t1e-1\t.2");
  ASSERT_TRUE(boxes) << boxes.error().message;
  ASSERT_EQ(boxes->size(), 2u);
  EXPECT_DOUBLE_EQ((*boxes)[0].left, .25);
  EXPECT_DOUBLE_EQ((*boxes)[0].top, 0);
  EXPECT_DOUBLE_EQ((*boxes)[0].right, .75);
  EXPECT_DOUBLE_EQ((*boxes)[0].bottom, .5);
  EXPECT_EQ((*boxes)[1].label, 2);
  EXPECT_TRUE(Labels("")->empty());
  EXPECT_TRUE(Labels("\n")->empty());
}

TEST(LabelFile, NumbersOfClassesMayBeWrittenAsNumpyDoes) {
  const auto boxes = Labels("0.000000e+00 0.5 0.25 0.5 0.5\n2.0 0.5 0.5 0.5 0.5\n");
  ASSERT_TRUE(boxes) << boxes.error().message;
  EXPECT_EQ((*boxes)[1].label, 2);
  for (const char* word : {"0.5", "nan", "1e30", "-1.0", "3.0"})
    EXPECT_FALSE(Labels(word + std::string(" .5 .5 .5 .5")));
}

TEST(LabelledSet, LabelsOfOtherToolsAreNamed) {
  const TestFolder folder;
  folder.Write("images/a.png", "");
  folder.Write("images/a.txt", "0 0.5 0.5 0.5 0.5\n");
  folder.Write("classes.txt", "person\n");
  const auto complaint = [&](const char* place) {
    const auto set = ReadLabelledSet(folder.Path(place), "");
    return set ? std::string() : set.error().message;
  };
  EXPECT_THAT(complaint(""), AllOf(HasSubstr("images/a.txt lies among the pictures"), HasSubstr("labels")));
  folder.Write("annotations/instances.json", "{}");
  EXPECT_THAT(complaint(""), AllOf(HasSubstr("annotations/instances.json"), HasSubstr("COCO")));
  folder.Write("labels/a.xml", "");
  EXPECT_THAT(complaint(""), AllOf(HasSubstr("labels/a.xml"), HasSubstr("Pascal VOC")));
  folder.Write("export/valid/images/b.png", "");
  EXPECT_THAT(complaint("export"), HasSubstr("--evaluate " + folder.Path("export/valid")));
  folder.Write("voc/Annotations/b.xml", "");
  EXPECT_THAT(complaint("voc"), AllOf(HasSubstr("has no folder images"), HasSubstr("Annotations/b.xml")));
}

TEST(LabelFile, PolygonsCountAsTheirBoxAndRepeatedLinesOnce) {
  const auto boxes = Labels("0 0.2 0.1 0.4 0.3 0.1 0.2\n0 0.2 0.1 0.4 0.3 0.1 0.2\n0 0.25 0.2 0.3 0.2\n");
  ASSERT_TRUE(boxes) << boxes.error().message;
  ASSERT_EQ(boxes->size(), 2u);
  EXPECT_DOUBLE_EQ((*boxes)[0].left, .1);
  EXPECT_DOUBLE_EQ((*boxes)[0].bottom, .3);
}

TEST(LabelFile, KeyPointsBehindABoxAreLeftOut) {
  const std::string box = "0 0.5 0.25 0.5 0.5";
  for (const auto& [points, count] : {std::pair(" 0.1 0.1 0.9 0.9", 4), std::pair(" 0.1 0.1 2 0 0 0", 6)}) {
    const auto boxes = Labels(box + points + "\n" + box + "\n", static_cast<size_t>(count));
    ASSERT_TRUE(boxes) << boxes.error().message;
    ASSERT_EQ(boxes->size(), 1u) << "the same box twice";
    EXPECT_DOUBLE_EQ((*boxes)[0].right, .75);
  }
  const TestFolder folder;
  folder.Write("data.yaml", "names: [person]\nkpt_shape: [17, 3]\n");
  EXPECT_EQ(ReadLabelForm(folder.Path(), "")->num_keypoint_numbers, 51u);
  folder.Write("data.yaml", "names: [person]\nkpt_shape: 17\n");
  EXPECT_THAT(ReadLabelForm(folder.Path(), "").error().message, AllOf(HasSubstr("line 2"), HasSubstr("kpt_shape")));
}

TEST(LabelFile, AnyOtherLineIsNamed) {
  const std::string good = "0 0.5 0.5 0.1 0.1\n";
  for (const char* bad :
       {"7 0.5 0.5 0.1 0.1", "1 0.5 0.5 0.1 0.1", "-1 0.5 0.5 0.1 0.1", "0 28 20 8 8", "0.5 0.5 0.1 0.1",
        "person 0.5 0.5 0.1 0.1", "0,0.5,0.5,0.1,0.1", "0 nan 0.5 0.1 0.1", "0 0.5 0.5 0 0.1", "0 0.5 0.5 0.1 0.1 0.9",
        "0 0.1 0.2 0.3 0.4 0.5 0.6 0.7", "0 0.5 0.5 inf 0.1", "0 0.1 0.1 0.2 0.1 0.3 0.1"}) {
    const auto boxes = Labels(good + bad + "\n");
    ASSERT_FALSE(boxes) << bad;
    EXPECT_THAT(boxes.error().message, AllOf(HasSubstr("a.txt"), HasSubstr("line 2")));
  }
}

TEST(ClassList, IsReadInItsFourForms) {
  const auto read = [](const std::string& name, const std::string& text) -> Result<Names> {
    const TestFolder folder;
    folder.Write("set/notes.md", "");
    folder.Write("set/" + name, text);
    const auto form = ReadLabelForm(folder.Path("set"), "val");
    if (!form) return form.error();
    return form->classes;
  };
  const Names wanted{"person", "dining table"};
  EXPECT_EQ(*read("classes.txt",
                  "\xef\xbb\xbf"
                  "0 person\r\n1 dining table\r\n"),
            wanted);
  EXPECT_EQ(*read("classes.txt", "person\ndining table\n"), wanted);
  EXPECT_EQ(*read("classes.txt", "1 dining table\n0 person\n"), wanted);
  EXPECT_EQ(*read("data.yaml", "train: a\nnc: 2\nnames:\n  0: person\n  1: dining table  # wood\nval: b\n"), wanted);
  EXPECT_EQ(*read("data.yaml", "names:\n- person\n- 'dining table'\n"), wanted);
  EXPECT_EQ(*read("data.yaml", "path: ../x  # root\nnames: ['person', \"dining table\"]\n"), wanted);
  EXPECT_EQ(*read("data.yaml", "names: [person, dining table]  # two\n"), wanted);
  EXPECT_EQ(*read("data.yaml", "names: {0: person, 1: dining table}\n"), wanted);
  EXPECT_EQ(*read("data.yaml", "names: [person,\n  dining table]\n"), wanted);
  EXPECT_EQ(*read("data.yaml", "names: ['driver''s seat', 'cup #1']\n"), (Names{"driver's seat", "cup #1"}));
  EXPECT_EQ(*read("data.yaml", "old:\n  names: [x, y]\nnames:\n  [person,  # she\n   dining table]\n"), wanted);
  EXPECT_EQ(*read("data.yaml", "names : {'1': dining table, '0': person}\n"), wanted);
  EXPECT_EQ(*read("classes.txt", "0: person\n1: dining table\n"), wanted);
  EXPECT_EQ(*read("labels/classes.txt", "person\ndining table\n"), wanted) << "as LabelImg writes it";
  EXPECT_EQ(*read("labels/val/classes.txt", "person\ndining table\n"), wanted) << "or so";
  EXPECT_EQ(*read("../data.yaml", "names: [person, dining table]\n"), wanted) << "as Roboflow lays it out";
  EXPECT_EQ(read("unrelated.txt", "")->size(), 80u);
  EXPECT_EQ(*read("classes.txt", "0 person\n2 cup\n"), (Names{"person", "", "cup"}));
  EXPECT_EQ(*read("classes.txt", "1 person\n2 cup\n"), (Names{"", "person", "cup"}));
  EXPECT_EQ(*read("classes.txt", "20 km/h\n50 km/h\n"), (Names{"20 km/h", "50 km/h"}));
  EXPECT_THAT(read("classes.txt", "0 person\n0 cup\n").error().message, HasSubstr("line 2"));
  EXPECT_THAT(read("data.yaml", "nc: 2\nnames: ['a' 'b']\n").error().message, HasSubstr("line 2"));
  EXPECT_THAT(read("data.yaml", "nc: 2\nnames: person\n").error().message, HasSubstr("line 2"));
  EXPECT_THAT(read("data.yaml", "nc: 2\n").error().message, HasSubstr("names"));
  EXPECT_THAT(read("data.yaml", "names:\n  0: a\n  0: b\n").error().message, HasSubstr("line 3"));
  EXPECT_THAT(read("classes.txt", "").error().message, HasSubstr("classes.txt"));
}

TEST(ClassList, OneListOfAnotherNameIsReadAndSeveralAreNamed) {
  const TestFolder folder;
  folder.Write("hyp.yaml", "lr0: 0.01\n");
  folder.Write("broken.yaml", "a: [\n");
  EXPECT_EQ(ReadLabelForm(folder.Path(), "")->classes.size(), 80u);
  folder.Write("mine.yaml", "path: x\nnames: {0: person, 1: cup}\n");
  EXPECT_EQ(ReadLabelForm(folder.Path(), "")->classes, (Names{"person", "cup"}));
  folder.Write("obj.names", "cup\nperson\n");
  EXPECT_THAT(ReadLabelForm(folder.Path(), "").error().message,
              AllOf(HasSubstr("mine.yaml and obj.names"), HasSubstr("data.yaml")));
  folder.Write("data.yaml", "names: [dog]\n");
  EXPECT_EQ(ReadLabelForm(folder.Path(), "")->classes, Names{"dog"});
  const TestFolder other;
  other.Write("obj.names", "cup\nperson\n");
  EXPECT_EQ(ReadLabelForm(other.Path(), "")->classes, (Names{"cup", "person"}));
}

TEST(LabelledSet, FindsTheLabelsAtTheSamePlace) {
  const TestFolder folder;
  folder.WritePicture("images/val/a/1.png", TestColour(0));
  folder.WritePicture("images/val/2.png", TestColour(0));
  folder.WritePicture("images/train/3.png", TestColour(0));
  folder.Write("labels/val/a/1.txt", "0 0.5 0.5 0.1 0.1\n");
  folder.Write("labels/classes.txt", "person\n");
  folder.Write("classes.txt", "person\n");
  const auto all = ReadLabelledSet(folder.Path(), ""), val = ReadLabelledSet(folder.Path(), "val");
  ASSERT_TRUE(all) << all.error().message;
  EXPECT_EQ(all->pictures.size(), 3u);
  ASSERT_EQ(val->pictures.size(), 2u);
  EXPECT_TRUE(val->pictures[0].boxes.empty());
  EXPECT_EQ(val->pictures[1].boxes.size(), 1u);
  EXPECT_THAT(ReadLabelledSet(folder.Path(), "test").error().message, AllOf(HasSubstr("train"), HasSubstr("val")));
  EXPECT_THAT(ReadLabelledSet(folder.Path(), "train").error().message, HasSubstr("no label file"));
  EXPECT_THAT(ReadLabelledSet(folder.Path("images"), "").error().message, HasSubstr("no folder images"));
  EXPECT_THAT(ReadLabelledSet(folder.Path("gone"), "").error().message, HasSubstr("does not exist"));
}

TEST(LabelledSet, LabelsThatBelongToNoPictureAreToldOfOnce) {
  const TestFolder folder;
  folder.WritePicture("images/val/1.png", TestColour(0));
  folder.WritePicture("images/val/2.png", TestColour(0));
  folder.Write("labels/val/1.txt", "0 0.5 0.5 0.1 0.1\n");
  folder.Write("labels/val/classes.txt", "person\n");
  const auto told = [&] {
    EXPECT_TRUE(StartLog({.keeps_text = true}).ok());
    EXPECT_TRUE(ReadLabelledSet(folder.Path(), "val"));
    const std::string text = LogText();
    EXPECT_TRUE(StopLog().ok());
    return text;
  };
  EXPECT_EQ(told(), "");
  folder.Write("labels/val/2.TXT", "0 0.5 0.5 0.1 0.1\n");
  folder.Write("labels/val/2.png.txt", "0 0.5 0.5 0.1 0.1\n");
  EXPECT_THAT(told(), AllOf(HasSubstr("2 label files"), HasSubstr("2.TXT")));
}

}  // namespace
}  // namespace yorb

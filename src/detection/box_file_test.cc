// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/box_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/log.h"
#include "detection/file_detector.h"
#include "detection/motion_category.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Result<BoxFile> Read(const std::string& text) {
  const TestFolder folder;
  return ReadBoxFile(folder.Write("boxes.txt", text));
}

Timestamp At(const char* text) { return *ParseTimestamp(text); }

ImageSet FrameAt(Timestamp time) {
  ImageSet images;
  images.timestamp = time;
  images.grey = cv::Mat(480, 640, CV_8UC1, cv::Scalar(0));
  return images;
}

TEST(BoxFile, PeopleAreReadAsPeopleHaveThem) {
  const auto file = Read(
      "\xef\xbb\xbf# timestamp left top right bottom visible_px\r\n1.50\t10 20 30 40 100\r\n\r\n1.5 50 60 70 80 9 "
      "\n2.0 1 2 3 4\n");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_TRUE(file->names_all);
  ASSERT_EQ(file->moments.size(), 2u);
  ASSERT_EQ(file->moments[0].boxes.size(), 2u);
  EXPECT_EQ(file->moments[0].boxes[0].name, "person");
  EXPECT_EQ(file->moments[0].boxes[1].bottom, 80);
  EXPECT_TRUE(Read("")->moments.empty());
  EXPECT_TRUE(Read("# nobody\n")->names_all);
}

TEST(BoxFile, JsonLinesAreReadInTheirSpellings) {
  const std::string wanted = R"("confidence": 0.9, "left": 10, "top": 20, "right": 90, "bottom": 200})";
  for (const std::string& line :
       {R"({"timestamp": 1.5, "boxes": [{"name": "person", )" + wanted + "]}",
        R"({"timestamp": "1.5", "boxes": [{"name": 0, )" + wanted + "]}",
        R"({"timestamp": 1.5, "boxes": [{"class": "0", )" + wanted + "]}",
        R"({"timestamp": 1.5, "class": "person", "confidence": 0.9, "box": [10, 20, 90, 200]})" + std::string("\n"),
        std::string(
            R"({"timestamp": 1.5, "detections": [{"class": 0, "confidence": 0.9, "box": [10, 20, 90, 200]}]})")}) {
    const auto file = Read(line);
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->moments.size(), 1u) << line;
    EXPECT_EQ(file->moments[0].time, At("1.5"));
    ASSERT_EQ(file->moments[0].boxes.size(), 1u);
    const Box& box = file->moments[0].boxes[0];
    EXPECT_EQ(box.name, "person");
    EXPECT_EQ(box.confidence, 0.9);
    EXPECT_EQ(box.bottom, 200);
  }
}

TEST(BoxFile, ClassesGoByTheNamesOfSeveralToolsAndFloats) {
  const std::string edges = ", \"left\": 1, \"top\": 2, \"right\": 30, \"bottom\": 40}]}\n";
  for (const char* key : {"\"class_name\": \"person\"", "\"cls\": 0.0", "\"class_id\": 0", "\"class\": 0.0"}) {
    const auto file = Read("{\"timestamp\": 1.5, \"boxes\": [{" + std::string(key) + edges);
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->moments.at(0).boxes.at(0).name, "person");
  }
  for (const char* key : {"\"class\": 0.5", "\"class\": 1e300", "\"category_id\": 1"})
    EXPECT_THAT(Read("{\"timestamp\": 1.5, \"boxes\": [{" + std::string(key) + edges).error().message,
                HasSubstr("line 1: a box needs a name"));
}

TEST(BoxFile, WhatIsNoJsonIsToldByItsColumnAndWhatMayBeDone) {
  EXPECT_THAT(Read("{\"timestamp\": 1.5, \"boxes\": [NaN]}\n").error().message,
              AllOf(HasSubstr("line 1: is no JSON from column 30 on, 'NaN]}'"), HasSubstr("write null")));
  EXPECT_THAT(Read("{\"timestamp\": 1.5, \"boxes\": []}\n{\"timestamp\": 2.5, \"bo").error().message,
              HasSubstr("line 2: is cut short"));
  EXPECT_THAT(Read("{\"timestamp\": 1.5, \"boxes\": []},\n").error().message, HasSubstr("line 1: is no JSON from"));
  EXPECT_THAT(Read("{\"frame\": 1, \"boxes\": []}\n").error().message,
              AllOf(HasSubstr("line 1: has no timestamp"), HasSubstr("a line is {")));
}

TEST(BoxFile, EdgesGoByTheNamesOfSeveralTools) {
  const std::string start = "{\"timestamp\": 1.5, \"boxes\": [{\"name\": \"person\", \"class\": 0, ";
  for (const char* edges : {"\"xmin\": 1, \"ymin\": 2, \"xmax\": 30, \"ymax\": 40", "\"xyxy\": [1, 2, 30, 40]",
                            "\"box\": {\"x1\": 1, \"y1\": 2, \"x2\": 30, \"y2\": 40}"}) {
    const auto file = Read(start + edges + "}]}\n");
    ASSERT_TRUE(file) << file.error().message;
    const Box& box = file->moments.at(0).boxes.at(0);
    EXPECT_EQ(box.name, "person");
    EXPECT_EQ(std::vector<double>({box.left, box.top, box.right, box.bottom}), std::vector<double>({1, 2, 30, 40}));
  }
  for (const char* unclear : {"\"bbox\": [1, 2, 30, 40]", "\"xywh\": [1, 2, 30, 40]"})
    EXPECT_THAT(Read(start + unclear + "}]}\n").error().message, HasSubstr("line 1: a box has no left; four numbers"));
}

TEST(BoxFile, OneDocumentIsReadAsItsLinesWouldBe) {
  const std::string one = "{\n \"timestamp\": 1.5,\n \"boxes\": [{\"name\": \"dog\", \"box\": [1, 2, 30, 40]}]\n}";
  const std::string other = "{\"timestamp\": 2.5, \"boxes\": []}";
  for (const std::string& text : {"[" + one + ", " + other + "]", "[" + other + ",\n" + one + "]\n", one}) {
    const auto file = Read(text);
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_FALSE(file->names_all);
    EXPECT_EQ(file->moments.size(), text == one ? 1u : 2u);
    const size_t num_boxes = file->moments.front().boxes.size() + file->moments.back().boxes.size();
    EXPECT_EQ(num_boxes, text == one ? 2u : 1u) << "front and back are one where there is one";
  }
  EXPECT_TRUE(Read("[]\n")->names_all) << "nobody, as in an empty file";
  EXPECT_THAT(Read("[" + other + ", 7]").error().message, HasSubstr("entry 2: is no JSON object"));
  EXPECT_THAT(Read("[" + other + ",\n").error().message, HasSubstr("line 1: is cut short"));
}

TEST(BoxFile, WhatNamesPicturesAndNoTimesIsToldWhatToDo) {
  const std::string results = "[{\"image_id\": 1, \"category_id\": 1, \"bbox\": [1, 2, 30, 40], \"score\": 0.9}]";
  EXPECT_THAT(Read(results).error().message, HasSubstr("COCO's files name pictures by their ids"));
  EXPECT_THAT(Read("{\"images\": [], \"annotations\": []}").error().message, HasSubstr("COCO's"));
  EXPECT_THAT(Read("{\"image\": \"a.png\", \"width\": 640, \"height\": 480, \"boxes\": []}").error().message,
              HasSubstr("`yorb detect SEQUENCE --json`"));
}

TEST(BoxFile, ConfidencesGoByThreeNamesAndAreSharesOf1) {
  const auto read = [](const std::string& confidence) {
    return Read(R"({"timestamp": 1.5, "boxes": [{"name": "person", )" + confidence + R"("box": [10, 20, 90, 200]}]})");
  };
  for (const char* key : {"confidence", "conf", "score"}) {
    const std::string name = std::string("\"") + key + "\": ";
    EXPECT_EQ(read(name + "0.3, ")->moments[0].boxes[0].confidence, 0.3) << key;
    for (const char* other : {"90, ", "-0.3, "})
      EXPECT_THAT(read(name + other).error().message, HasSubstr("line 1: a confidence is a number from 0 to 1"));
  }
  EXPECT_EQ(read("")->moments[0].boxes[0].confidence, 1);
}

TEST(BoxFile, WhatIsWrittenIsReadAgain) {
  const std::string line =
      ToJsonLine({At("1305031102.175304"), "a \"b\".png", 640, 480}, {{"driver's seat", 0.5, 1.25, 2, 3, 4}});
  const auto file = Read(line + "\n" + ToJsonLine({At("1305031103"), {}, {}, {}}, {}) + "\n");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_NEAR(file->moments[0].time.seconds(), 1305031102.175304, 1e-6);
  EXPECT_EQ(file->moments[0].boxes[0].name, "driver's seat");
  EXPECT_EQ(file->moments[0].boxes[0].left, 1.25);
  ASSERT_EQ(file->moments.size(), 2u);
  EXPECT_TRUE(file->moments[1].boxes.empty());
  EXPECT_THAT(line, HasSubstr("1305031102.175304"));
}

TEST(BoxFile, BadLinesAreNamed) {
  for (const char* text :
       {"1.5 1 2 3 4 5\n1.6 a b c d\n", "1.5 1 2 3 4 5\n1.6 1 2 3\n",
        "{\"timestamp\": 1, \"boxes\": []}\n{\"boxes\": []}\n", "{\"timestamp\": 1, \"boxes\": []}\nperson\n",
        "{\"timestamp\": 1, \"boxes\": []}\n{\"timestamp\": 2}\n",
        "{\"timestamp\": 1, \"boxes\": []}\n{\"timestamp\": 2, \"boxes\": \"none\", \"box\": [1, 2, 3, 4]}\n",
        "{\"timestamp\": 1, \"boxes\": []}\n{\"timestamp\": 2, \"boxes\": {}, \"box\": [1, 2, 3, 4]}\n",
        "{\"timestamp\": 1, \"boxes\": []}\n{\"timestamp\": 2, \"boxes\": [{\"name\": 90, \"left\": 1}]}\n",
        "{\"timestamp\": 1, \"boxes\": []}\n{\"timestamp\": 2, \"boxes\": [{\"name\": \"person\", \"left\": 1}]}\n"}) {
    const auto file = Read(text);
    ASSERT_FALSE(file) << text;
    EXPECT_THAT(file.error().message, AllOf(HasSubstr("boxes.txt"), HasSubstr("line 2")));
  }
  EXPECT_THAT(Read("1.5 0.1 0.2 0.3 0.4 1\n").error().message, HasSubstr("fractions"));
  EXPECT_EQ(Read("1.5 30 20 10 40 1\n1.5 nan 2 3 4 1\n1.5 10 20 30 40 1\n")->num_dropped(), 2u);
}

TEST(BoxFile, StampsThatCountNanosecondsAreRefusedWithAWordAboutTheUnit) {
  for (const char* text : {"1600000000033333000 10 20 30 40 5\n", "1600000000033.333 10 20 30 40\n",
                           "{\"timestamp\": 1600000000033333000, \"boxes\": []}\n",
                           "{\"timestamp\": \"1600000000033333000\", \"boxes\": []}\n"}) {
    EXPECT_THAT(Read(text).error().message,
                AllOf(HasSubstr("line 1"), HasSubstr("160000000003"), HasSubstr("nanoseconds")));
  }
}

TEST(FileDetector, ABoxBelongsToTheNearestFrameWithin15Milliseconds) {
  const auto file = Read("1.010 10 20 30 40 1\n1.020 50 60 700 80 1\n9 1 2 30 4 1\n");
  const std::vector<Timestamp> frames{At("1.0"), At("1.033"), At("2")};
  const auto detector = FileDetector::Make(*file, frames);
  ASSERT_TRUE(detector) << detector.error().message;
  EXPECT_EQ((*detector)->num_unmatched(), 1u);
  EXPECT_EQ((*detector)->Detect(FrameAt(frames[0]))->boxes[0].left, 10);
  const auto second = (*detector)->Detect(FrameAt(frames[1]));
  ASSERT_EQ(second->boxes.size(), 1u);
  EXPECT_EQ(second->boxes[0].right, 640) << "cut to the picture";
  EXPECT_TRUE((*detector)->Detect(FrameAt(frames[2]))->has_looked) << "people.txt names all people";
}

TEST(FileDetector, ABoxThatIsGivenTwiceIsOne) {
  const std::string once = "1 10 20 30 40 1\n1 50 60 70 80 1\n2 1 2 3 4 1\n";
  const auto detector = FileDetector::Make(*Read(once + once), {At("1"), At("2")});
  ASSERT_TRUE(detector) << detector.error().message;
  EXPECT_EQ((*detector)->Detect(FrameAt(At("1")))->boxes.size(), 2u);
  EXPECT_EQ((*detector)->Detect(FrameAt(At("2")))->boxes.size(), 1u);
}

TEST(FileDetector, AFrameWithoutALineWasNotLookedAt) {
  const auto file = Read("{\"timestamp\": 1, \"boxes\": []}\n");
  const auto detector = FileDetector::Make(*file, {At("1"), At("2")});
  ASSERT_TRUE(detector);
  EXPECT_TRUE((*detector)->Detect(FrameAt(At("1")))->has_looked);
  EXPECT_TRUE((*detector)->Detect(FrameAt(At("1")))->says_nobody);
  EXPECT_FALSE((*detector)->Detect(FrameAt(At("2")))->has_looked);
  EXPECT_FALSE((*detector)->Detect(FrameAt(At("2")))->says_nobody);
}

TEST(FileDetector, AMomentWhoseBoxesWereAllDroppedDoesNotSayThatNobodyIsThere) {
  for (const char* text : {"1 nan 20 30 40 9\n1 30 20 10 40 9\n2 10 20 30 40 9\n",
                           "{\"timestamp\": 1, \"boxes\": [{\"name\": \"person\", \"box\": [30, 20, 10, 40]}]}\n"}) {
    const auto detector = FileDetector::Make(*Read(text), {At("1"), At("2")});
    ASSERT_TRUE(detector);
    const auto found = (*detector)->Detect(FrameAt(At("1")));
    EXPECT_TRUE(found->boxes.empty());
    EXPECT_FALSE(found->says_nobody) << "somebody was meant: " << text;
  }
}

TEST(FileDetector, BoxesOutsideOfThePictureAreToldOfOnce) {
  const auto file = Read("1 700 500 900 800 9\n2 700 500 900 800 9\n");
  const auto detector = FileDetector::Make(*file, {At("1"), At("2")});
  ASSERT_TRUE(detector);
  ASSERT_TRUE(StartLog({.keeps_text = true}).ok());
  for (const char* time : {"1", "2"}) {
    const auto found = (*detector)->Detect(FrameAt(At(time)));
    EXPECT_TRUE(found->boxes.empty());
    EXPECT_FALSE(found->says_nobody) << "somebody was meant";
  }
  EXPECT_THAT(LogText(), HasSubstr("640x480"));
  EXPECT_EQ(LogText().find("outside"), LogText().rfind("outside"));
  EXPECT_TRUE(StopLog().ok());
}

TEST(FileDetector, BoxesOfAPictureOfAnotherSizeAreScaled) {
  const auto boxes_of = [](const std::string& size) {
    const auto file =
        Read("{\"timestamp\": 1, " + size + "\"boxes\": [{\"name\": \"person\", \"box\": [10, 20, 30, 40]}]}\n");
    return (*FileDetector::Make(*file, {At("1")}))->Detect(FrameAt(At("1")));
  };
  for (const char* same :
       {"", "\"width\": 640, \"height\": 480, ", "\"width\": 320, ", "\"width\": -1, \"height\": 2, "}) {
    EXPECT_EQ(boxes_of(same)->boxes.at(0).right, 30) << same;
  }
  const auto half = boxes_of("\"width\": 320, \"height\": 240, ");
  EXPECT_EQ(half->boxes.at(0).left, 20);
  EXPECT_EQ(half->boxes.at(0).bottom, 80);
  const auto wide = boxes_of("\"width\": 1920, \"height\": 1080, ");
  ASSERT_FALSE(wide);
  EXPECT_THAT(wide.error().message,
              AllOf(HasSubstr("boxes.txt, line 1"), HasSubstr("1920x1080"), HasSubstr("640x480")));
}

TEST(FileDetector, AFileOfAnotherRecordingIsRefused) {
  const auto detector = FileDetector::Make(*Read("100 10 20 30 40 1\n"), {At("1"), At("2")});
  ASSERT_FALSE(detector);
  EXPECT_THAT(detector.error().message, AllOf(HasSubstr("boxes.txt"), HasSubstr("100.000000"), HasSubstr("2.000000")));
  EXPECT_TRUE(FileDetector::Make(*Read(""), {At("1")}));
  const auto late = FileDetector::Make(*Read("1.02 10 20 30 40 1\n1.98 10 20 30 40 1\n"), {At("1"), At("2")});
  EXPECT_THAT(late.error().message, HasSubstr("; the nearest is 20 ms away"));
  EXPECT_EQ(late.error().message.find("another recording"), std::string::npos);
}

TEST(MotionTable, GoesByNameHoweverItIsSpelt) {
  const MotionTable table = MotionTable::Default();
  EXPECT_EQ(table.Of("Person"), Motion::kHigh);
  EXPECT_EQ(table.Of("DOG"), Motion::kHigh);
  EXPECT_EQ(table.Of("cell_phone"), Motion::kLow);
  EXPECT_EQ(table.Of("chair"), Motion::kLow);
  EXPECT_EQ(table.Of("Dining Table"), Motion::kStatic);
  EXPECT_TRUE(table.Knows("dining-table"));
  EXPECT_EQ(table.Of("flying saucer"), Motion::kStatic);
  EXPECT_FALSE(table.Knows("flying saucer"));
}

TEST(MotionTable, AFileIsLaidOverTheBuiltInOne) {
  const TestFolder folder;
  const auto table =
      ReadMotionTable(folder.Write("classes.txt", "# motion\r\n0 person static\r\n1 robot arm high\nvase low\n"));
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_EQ(table->Of("person"), Motion::kStatic);
  EXPECT_EQ(table->Of("robot_arm"), Motion::kHigh);
  EXPECT_EQ(table->Of("vase"), Motion::kLow);
  EXPECT_EQ(table->Of("cat"), Motion::kHigh);
  EXPECT_THAT(ReadMotionTable(folder.Write("bad.txt", "0 person high\n1 chair sometimes\n")).error().message,
              HasSubstr("line 2"));
}

}  // namespace
}  // namespace yorb

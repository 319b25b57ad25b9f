// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/judge_detector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/log.h"
#include "datasets/test_recording.h"
#include "runs/draw_boxes.h"
#include "runs/picture_source.h"

namespace yorb {
namespace {

/// Says the same of every picture.
class SureDetector : public Detector {
 public:
  explicit SureDetector(std::vector<Box> boxes) : boxes_(std::move(boxes)) {}
  Result<Detections> Detect(const ImageSet&) override { return Detections{true, boxes_}; }

 private:
  std::vector<Box> boxes_;
};

TEST(JudgeDetector, ClassesAreMatchedByNameHoweverTheyAreNumberedAndSpelt) {
  const TestFolder folder;
  folder.WritePicture("images/a.png", TestColour(0));  // 64x48
  folder.Write("labels/a.txt", "0 0.5 0.5 0.5 0.5\n2 0.25 0.25 0.5 0.5\n");
  folder.Write("classes.txt", "dining_table\ncup\nsofa\n");
  const auto set = ReadLabelledSet(folder.Path(), "");
  ASSERT_TRUE(set) << set.error().message;
  SureDetector detector({{"Dining Table", .9, 16, 12, 48, 36}, {"unknown", .9, 0, 0, 32, 24}});
  const auto judgement = JudgeDetector(*set, detector, {});
  ASSERT_TRUE(judgement) << judgement.error().message;
  const auto json = nlohmann::json::parse(JudgementJson(*judgement));
  ASSERT_EQ(json["classes"].size(), 2u);
  EXPECT_EQ(json["classes"][0]["name"], "dining_table");
  EXPECT_NEAR(json["classes"][0]["ap50"], 1, 1e-9);
  EXPECT_EQ(json["classes"][0]["truth"], 1);
  EXPECT_EQ(json["classes"][1]["name"], "sofa");
  EXPECT_TRUE(json["classes"][1]["precision"].is_null());
  EXPECT_NEAR(json["map50"], .5, 1e-9);
  EXPECT_EQ(json["confidence"], .25);
  EXPECT_THAT(JudgementText(*judgement), testing::HasSubstr("1 pictures"));
  const auto only = JudgeDetector(*set, detector, {.classes = {"dining table"}});
  EXPECT_EQ(only->scores.classes.size(), 1u);
}

TEST(JudgeDetector, ClassesOfOneNameCountAsOneAndAreToldOf) {
  const TestFolder folder;
  folder.WritePicture("images/a.png", TestColour(0));  // 64x48
  folder.Write("labels/a.txt", "0 0.25 0.25 0.25 0.25\n2 0.75 0.75 0.25 0.25\n");
  folder.Write("classes.txt", "person\ncup\nPerson\n");
  const auto set = ReadLabelledSet(folder.Path(), "");
  ASSERT_TRUE(set) << set.error().message;
  SureDetector detector({{"person", .9, 8, 6, 24, 18}, {"person", .9, 40, 30, 56, 42}});
  testing::internal::CaptureStderr();
  const auto judgement = JudgeDetector(*set, detector, {});
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr("0 ('person') and 2 ('Person')"));
  ASSERT_TRUE(judgement) << judgement.error().message;
  ASSERT_EQ(judgement->scores.classes.size(), 1u);
  EXPECT_EQ(judgement->scores.classes[0].num_true, 2u);
  EXPECT_NEAR(judgement->scores.classes[0].recall, 1, 1e-9);
}

TEST(JudgeDetector, JudgesTheOthersWherePicturesCannotBeRead) {
  const TestFolder folder;
  folder.Write("images/a.png", "");
  folder.WritePicture("images/b.png", TestColour(0));  // 64x48
  folder.Write("labels/a.txt", "0 0.5 0.5 0.5 0.5\n");
  folder.Write("labels/b.txt", "0 0.5 0.5 0.5 0.5\n");
  folder.Write("classes.txt", "cup\n");
  const auto set = ReadLabelledSet(folder.Path(), "");
  ASSERT_TRUE(set) << set.error().message;
  SureDetector detector({{"cup", .9, 16, 12, 48, 36}});
  const auto judgement = JudgeDetector(*set, detector, {});
  ASSERT_TRUE(judgement) << judgement.error().message;
  EXPECT_EQ(judgement->num_pictures, 1u);
  EXPECT_NEAR(judgement->scores.map50.value(), 1, 1e-9);
  EXPECT_THAT(judgement->unreadable.Told().error().message, testing::HasSubstr("a.png"));
}

TEST(Unreadable, NamesTheFirstThreeAndCountsTheOthers) {
  Unreadable some, others;
  EXPECT_TRUE(some.Told().ok());
  some.Add(BadInput("a is torn"));
  EXPECT_EQ(some.Told().error().message, "a is torn");
  for (const char* name : {"b", "c", "d"}) others.Add(BadInput(name + std::string(" is torn")));
  some.Add(others);
  EXPECT_EQ(some.Told().error().message,
            "4 pictures or sources cannot be read: a is torn; b is torn; c is torn; and 1 more");
}

TEST(JudgeDetector, TellsOfASetAndANetworkWithoutANameInCommon) {
  const TestFolder folder;
  folder.WritePicture("images/a.png", TestColour(0));
  folder.Write("labels/a.txt", "0 0.5 0.5 0.5 0.5\n");
  folder.Write("classes.txt", "Mensch\n");
  const auto set = ReadLabelledSet(folder.Path(), "");
  ASSERT_TRUE(set) << set.error().message;
  const auto told = [&](std::vector<Box> boxes) {
    EXPECT_TRUE(StartLog({.keeps_text = true}).ok());
    SureDetector detector(std::move(boxes));
    EXPECT_TRUE(JudgeDetector(*set, detector, {}));
    const std::string text = LogText();
    EXPECT_TRUE(StopLog().ok());
    return text;
  };
  EXPECT_THAT(told({{"person", .9, 16, 12, 48, 36}}),
              testing::AllOf(testing::HasSubstr("'person'"), testing::HasSubstr("'Mensch'")));
  EXPECT_EQ(told({{"person", .9, 16, 12, 48, 36}, {"mensch", .1, 0, 0, 9, 9}}), "");
  EXPECT_EQ(told({}), "");
}

TEST(PictureSource, GivesPicturesFoldersAndSequences) {
  const TestFolder folder;
  WriteRecording(folder, "sequence", 3);
  folder.WritePicture("folder/b/2.png", TestColour(0));
  folder.WritePicture("folder/1.png", TestColour(0));
  folder.Write("folder/broken.png", "no picture");
  std::filesystem::create_directories(folder.Path("empty"));

  auto sequence = OpenPictureSource(folder.Path("sequence"));
  ASSERT_TRUE(sequence) << sequence.error().message;
  size_t count = 0;
  for (; (*sequence)->HasNext(); ++count) {
    const auto picture = (*sequence)->Next();
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_EQ(ToString(*picture->time), Stamp(static_cast<int>(count)));
    EXPECT_EQ(picture->pixels.size(), cv::Size(64, 48));
  }
  EXPECT_EQ(count, 3u);

  auto pictures = OpenPictureSource(folder.Path("folder"));
  ASSERT_TRUE(pictures);
  EXPECT_EQ((*pictures)->Next()->name, "1.png");
  EXPECT_EQ((*pictures)->Next()->name, "b/2.png");
  const auto broken = (*pictures)->Next();
  EXPECT_FALSE(broken);
  EXPECT_FALSE((*pictures)->HasNext());
  EXPECT_FALSE(OpenPictureSource(folder.Path("empty")));
  EXPECT_THAT(OpenPictureSource("").error().message, testing::HasSubstr("empty name"));
  EXPECT_FALSE((*OpenPictureSource(folder.Path("gone.png")))->Next());
}

TEST(DrawBoxes, ChangesThePictureAlongTheBoxAndNotTheOriginal) {
  const cv::Mat picture(100, 200, CV_8UC1, cv::Scalar(10));
  const cv::Mat drawn = DrawBoxes(picture, {{"person", .9, 50, 40, 150, 90}});
  EXPECT_EQ(drawn.type(), CV_8UC3);
  EXPECT_NE(drawn.at<cv::Vec3b>(60, 50), cv::Vec3b(10, 10, 10));
  EXPECT_EQ(drawn.at<cv::Vec3b>(60, 100), cv::Vec3b(10, 10, 10));
  EXPECT_EQ(picture.at<uint8_t>(60, 50), 10);
}

}  // namespace
}  // namespace yorb

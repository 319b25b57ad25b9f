// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// `yorb detect` from outside: boxes, JSON, exit codes, complaints, evaluation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "datasets/test_recording.h"
#include "detection/box_file.h"
#include "detection/test_network.h"
#include "pictures/picture_file.h"

namespace yorb {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct Outcome {
  int code = -1;
  std::string out, err;
};

class Detect : public testing::Test {
 protected:
  Detect() {
    folder_.Write("net.onnx", TwoColourNetwork().Bytes());
    for (int i = 0; i < 2; ++i) {
      cv::Mat picture(64, 64, CV_8UC3, cv::Scalar::all(20));
      picture(cv::Rect(8, 16, 8, 8)).setTo(cv::Scalar(0, 0, 255));
      if (i == 1) picture(cv::Rect(40, 48, 8, 8)).setTo(cv::Scalar(0, 255, 0));
      folder_.WritePicture("set/images/" + std::to_string(i) + ".png", picture);
      folder_.Write("set/labels/" + std::to_string(i) + ".txt", "0 0.1875 0.3125 0.125 0.125\n");
    }
    folder_.Write("set/classes.txt", "Person\n");
  }

  /// `arguments` as a shell has them, within the scratch folder.
  Outcome Call(const std::string& arguments) const {
    const std::string command =
        "cd '" + folder_.Path() + "' && '" YORB_PROGRAM "' detect " + arguments + " >out 2>err </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder_.Read("out"), folder_.Read("err")};
  }

  void ExpectRefused(const std::string& word, const std::string& arguments) const {
    const Outcome outcome = Call(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(word));
  }

  TestFolder folder_;
};

TEST_F(Detect, JsonIsALineAPicture) {
  const Outcome outcome = Call("set/images --model net.onnx --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const size_t end = outcome.out.find('\n');
  const auto first = nlohmann::json::parse(outcome.out.substr(0, end)),
             second = nlohmann::json::parse(outcome.out.substr(end + 1));
  EXPECT_EQ(first["image"], "set/images/0.png");
  EXPECT_EQ(first["width"], 64);
  ASSERT_EQ(first["boxes"].size(), 1u);
  EXPECT_EQ(first["boxes"][0]["name"], "person");
  EXPECT_NEAR(first["boxes"][0]["left"], 8, 0.01);
  EXPECT_NEAR(first["boxes"][0]["bottom"], 24, 0.01);
  EXPECT_EQ(second["boxes"].size(), 2u);
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Detect, OfASequenceItWritesWhatABoxFileIs) {
  WriteRecording(folder_, "sequence", 3);
  const Outcome outcome = Call("sequence --model net.onnx --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto file = ReadBoxFile(folder_.Path("out"));
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->moments.size(), 3u);
  EXPECT_EQ(ToString(file->moments[1].time), Stamp(1));
}

TEST_F(Detect, TextNamesWhatIsThereAndOnlyWhatWasAskedFor) {
  EXPECT_THAT(Call("set/images/1.png --model net.onnx").out, AllOf(HasSubstr("person"), HasSubstr("cup")));
  const Outcome outcome = Call("set/images/1.png --model net.onnx --classes Cup --save drawn");
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("cup"), testing::Not(HasSubstr("person "))));
  EXPECT_EQ(ReadPictureFile(folder_.Path("drawn/1.png")).pixels.size(), cv::Size(64, 64));
  ExpectRefused("cup", "set/images/1.png --model net.onnx --classes cap --json");
  for (const char* same : {"Cup,", "' cup '", "1"})
    EXPECT_EQ(Call(std::string("set/images/1.png --model net.onnx --classes ") + same).out,
              Call("set/images/1.png --model net.onnx --classes Cup").out);
}

TEST_F(Detect, PicturesThatWereThereBeforeStay) {
  folder_.Write("album/0.png", "somebody's");
  const Outcome outcome = Call("set/images --model net.onnx --save album");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(folder_.Read("album/0.png"), "somebody's");
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("album/0.png was there before"), HasSubstr("album/0_2.png")));
  for (const char* name : {"album/0_2.png", "album/1.png"})
    EXPECT_EQ(ReadPictureFile(folder_.Path(name)).pixels.size(), cv::Size(64, 64)) << name;
}

TEST_F(Detect, ASecondRunReplacesThePicturesOfTheFirst) {
  folder_.Write("album/0.png", "somebody's");
  folder_.WritePicture("other/1.png", cv::Mat(32, 32, CV_8UC3, cv::Scalar::all(20)));
  folder_.WritePicture("photo.jpg", cv::Mat(64, 64, CV_8UC3, cv::Scalar::all(20)));
  const std::string pictures = "set/images other photo.jpg ";
  ASSERT_EQ(Call(pictures + "--model net.onnx --save album").code, 0);
  const std::string first = folder_.Read("album/1.png");
  const Outcome again = Call("photo.jpg other ./set/../set/images --model net.onnx --classes cup --save album");
  EXPECT_EQ(again.code, 0) << again.err;
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.Path("album")))
    names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::UnorderedElementsAre("0.png", "0_2.png", "1.png", "1_2.png", "photo.jpg"));
  EXPECT_EQ(folder_.Read("album/0.png"), "somebody's");
  EXPECT_NE(folder_.Read("album/1.png"), first) << "the person's box is gone";
  EXPECT_EQ(ReadPictureFile(folder_.Path("album/1_2.png")).pixels.size(), cv::Size(32, 32));
}

TEST_F(Detect, VideosInAFolderAreNotPassedOverInSilence) {
  folder_.Write("clips/a.mp4", "");
  ExpectRefused("clips/a.mp4, are read where they are named", "clips --model net.onnx --json");
  folder_.WritePicture("clips/b.png", cv::Mat(64, 64, CV_8UC3, cv::Scalar::all(20)));
  const Outcome outcome = Call("clips --model net.onnx --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("clips/a.mp4, are read where they are named"));
}

TEST_F(Detect, UnreadablePicturesAreNamedAfterTheOthers) {
  folder_.Write("broken.png", "no picture");
  const Outcome outcome = Call("gone.png broken.png set/images/0.png --model net.onnx --json");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.out, HasSubstr("set/images/0.png"));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("gone.png"), HasSubstr("broken.png")));
}

TEST_F(Detect, BadInputIsRefusedInOneLine) {
  folder_.Write("bad.onnx", "no network");
  ExpectRefused("bad.onnx", "set/images --model bad.onnx --json");
  ExpectRefused("gone.onnx", "set/images --model gone.onnx --json");
  ExpectRefused("picture", "--model net.onnx --json");
  ExpectRefused("--conf", "set/images --model net.onnx --conf 2 --json");
  ExpectRefused("names no class", "set/images --model net.onnx --classes , --json");
  ExpectRefused("'preson' is no class", "set/images --model net.onnx --classes person,preson --json");
  ExpectRefused("'99' is no class", "set/images --model net.onnx --classes 99 --json");
  ExpectRefused("--iou", "set/images --model net.onnx --iou x --json");
  ExpectRefused("--save", "set/images --model net.onnx --save /proc/nowhere --json");
  ExpectRefused("where the pictures are", "set/images --model net.onnx --save set/images --json");
  ExpectRefused("where the pictures are", "set/images/0.png --model net.onnx --save ./set/../set/images --json");
  ExpectRefused("--set requires --evaluate", "set/images --model net.onnx --set val --json");
  ExpectRefused("--evaluate", "set/images --model net.onnx --evaluate set --json");
  ExpectRefused("no folder", "--model net.onnx --evaluate set --set val --json");
}

TEST_F(Detect, EvaluationGivesOneDocument) {
  const Outcome outcome = Call("--evaluate set --model net.onnx --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["classes"].size(), 1u);
  EXPECT_EQ(json["classes"][0]["name"], "Person");
  EXPECT_NEAR(json["classes"][0]["ap50"], 1, 1e-9);
  EXPECT_NEAR(json["classes"][0]["recall"], 1, 1e-9);
  EXPECT_EQ(json["classes"][0]["truth"], 2);
  EXPECT_GT(json["latency_ms"], 0);
  EXPECT_NEAR(json["map50_95"], 1, 1e-9);
  folder_.Write("set/labels/1.txt", "0 10 10 20 20\n");
  ExpectRefused("1.txt, line 1", "--evaluate set --model net.onnx --json");
}

}  // namespace
}  // namespace yorb

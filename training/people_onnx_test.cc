// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_onnx.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <onnx/checker.h>

#include <opencv2/dnn.hpp>

#include "training/people_check.h"
#include "training/test_people.h"

namespace yorb {
namespace {

struct PeopleFixture {
  OnnxModel before = MakeTinyDetector();
  FeatureTaps taps = *FindFeatureTaps(before, "tiny.onnx");
  PeopleHead head{taps.fine_channels, taps.coarse_channels};
  OnnxModel after = *ReadOnnxBytes(OnnxBytes(*WithPeopleHead(before, taps, head, "tiny.onnx")), "after.onnx");

  cv::Mat picture() const {
    cv::Mat picture(kTinyInput, CV_8UC3);
    cv::RNG(3).fill(picture, cv::RNG::UNIFORM, 0, 256);
    return picture;
  }
};

/// All outputs of a file as OpenCV reads it.
std::vector<cv::Mat> OpenCvOutputsOf(const OnnxModel& model, const cv::Mat& picture) {
  const std::string bytes = OnnxBytes(model);
  cv::dnn::Net net = cv::dnn::readNetFromONNX(bytes.data(), bytes.size());
  net.setInput(cv::dnn::blobFromImage(picture, 1 / 255.0, cv::Size(), cv::Scalar(), true));
  std::vector<std::string> names;
  for (const OnnxValue& output : model.outputs) names.push_back(output.name);
  std::vector<cv::Mat> outputs, kept;
  net.forward(outputs, names);
  for (const cv::Mat& output : outputs) kept.push_back(output.clone());
  return kept;
}

TEST(PeopleOnnx, OneOutputIsAddedAndTheOthersStayToTheBit) {
  const PeopleFixture fixture;
  ASSERT_EQ(fixture.after.outputs.size(), 4u);
  EXPECT_EQ(fixture.after.outputs.back().name, "people");
  EXPECT_EQ(fixture.after.outputs.back().dims, (std::vector<int64_t>{1, 1, 8, 12}));
  EXPECT_EQ(fixture.after.metadata.at("people"), "8");
  const auto before = OpenCvOutputsOf(fixture.before, fixture.picture()),
             after = OpenCvOutputsOf(fixture.after, fixture.picture());
  for (size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(fixture.after.outputs[i].name, fixture.before.outputs[i].name);
    EXPECT_EQ(cv::norm(before[i], after[i], cv::NORM_INF), 0) << fixture.before.outputs[i].name;
  }
  for (const auto& [key, value] : fixture.before.metadata) EXPECT_EQ(fixture.after.metadata.at(key), value);
}

TEST(PeopleOnnx, AMapIsTakenOffAgainWithoutATrace) {
  const PeopleFixture fixture;
  EXPECT_EQ(OnnxBytes(WithoutPeopleHead(fixture.after)), OnnxBytes(fixture.before));
  EXPECT_EQ(OnnxBytes(WithoutPeopleHead(fixture.before)), OnnxBytes(fixture.before));
}

TEST(PeopleOnnx, TheMapIsLibtorchs) {
  const PeopleFixture fixture;
  const auto difference =
      CheckPeopleOutput({fixture.before, fixture.after}, fixture.taps, fixture.head, fixture.picture());
  ASSERT_TRUE(difference) << difference.error().message;
  EXPECT_LT(*difference, 1e-3);
  const cv::Mat map = OpenCvOutputsOf(fixture.after, fixture.picture()).back();
  double least = 0, most = 0;
  cv::minMaxIdx(map, &least, &most);
  EXPECT_GT(most - least, 1e-2);  // so that equality says something
}

TEST(PeopleOnnx, AnotherHeadIsToldFromTheOneInTheFile) {
  const PeopleFixture fixture;
  const PeopleHead other(fixture.taps.fine_channels, fixture.taps.coarse_channels);
  EXPECT_FALSE(CheckPeopleOutput({fixture.before, fixture.after}, fixture.taps, other, fixture.picture()));
}

TEST(PeopleOnnx, TheRulesOfOnnxHold) {
  onnx::ModelProto model;
  ASSERT_TRUE(model.ParseFromString(OnnxBytes(PeopleFixture().after)));
  try {
    onnx::checker::check_model(model);
  } catch (const std::exception& wrong) {
    FAIL() << wrong.what();
  }
}

TEST(PeopleOnnx, NetworksThatDoNotFitAreRefused) {
  const PeopleFixture fixture;
  const auto twice = FindFeatureTaps(fixture.after, "after.onnx");
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().message, testing::HasSubstr("already"));
  OnnxModel strange = fixture.before;
  for (OnnxNode& node : strange.nodes) {
    if (node.outputs[0] == "stride16") node.outputs[0] = "other";
  }
  EXPECT_FALSE(FindFeatureTaps(strange, "strange.onnx"));
}

}  // namespace
}  // namespace yorb

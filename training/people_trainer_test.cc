// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_trainer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/random.h"
#include "training/people_cells.h"
#include "training/test_people.h"

namespace yorb {
namespace {

/// Noise with a bright thing on it that shall be a person, a third as large as the picture.
Scene MakeScene(int64_t i, const cv::Size& size) {
  Random random(5, static_cast<uint64_t>(i));
  Scene scene{cv::Mat(size, CV_8UC3), {}, {}};
  scene.people_mask = cv::Mat(size, CV_8U, cv::Scalar(kMaskNobody));
  cv::RNG(random.Next()).fill(scene.pixels, cv::RNG::UNIFORM, 60, 120);
  const int width = size.width / 3, height = size.height / 3;
  const cv::Rect person(static_cast<int>(random.Below(static_cast<uint32_t>(size.width - width))),
                        static_cast<int>(random.Below(static_cast<uint32_t>(size.height - height))), width, height);
  scene.pixels(person).setTo(cv::Scalar(random.Uniform(0, 50), random.Uniform(150, 255), random.Uniform(150, 255)));
  scene.people_mask(person).setTo(kMaskPerson);
  return scene;
}

Result<FeatureSet> MakeSet(const OnnxModel& model, const FeatureTaps& taps, int num_threads) {
  std::vector<FeatureMaker> makers;
  for (int i = 0; i < num_threads; ++i) makers.push_back(*FeatureMaker::Make(model, taps, "tiny.onnx"));
  const auto make = [&](int64_t i) -> Result<Scene> { return MakeScene(i, taps.input); };
  return MakeFeatures({8, make}, std::move(makers), [](int64_t) { return true; });
}

TEST(PeopleMap, FeaturesDoNotDependOnTheNumberOfThreads) {
  const OnnxModel model = MakeTinyDetector();
  const FeatureTaps taps = *FindFeatureTaps(model, "tiny.onnx");
  const auto one = MakeSet(model, taps, 1), three = MakeSet(model, taps, 3);
  ASSERT_TRUE(one && three);
  EXPECT_TRUE(one->fine.equal(three->fine));
  EXPECT_TRUE(one->coarse.equal(three->coarse));
  EXPECT_TRUE(one->labels.equal(three->labels));
  EXPECT_EQ(one->fine.sizes(), (std::vector<int64_t>{8, taps.fine_channels, 8, 12}));
  EXPECT_EQ(one->coarse.sizes(), (std::vector<int64_t>{8, taps.coarse_channels, 4, 6}));
}

TEST(PeopleMap, LearnsEightPicturesByHeart) {
  torch::set_num_threads(1);
  const std::string path = YORB_SOURCE_DIR "/models/yolo_mo.onnx";  // there is little to see for weights by chance
  const auto read = ReadOnnxFile(path);
  ASSERT_TRUE(read) << read.error().message;
  const OnnxModel model = WithoutPeopleHead(*read);
  const FeatureTaps taps = *FindFeatureTaps(model, path);
  const auto set = MakeSet(model, taps, 1);
  ASSERT_TRUE(set) << set.error().message;
  PeopleHead head(taps.fine_channels, taps.coarse_channels);
  EXPECT_LT(MeasureCells(head, *set).iou, 0.5);
  double loss = 1;
  int num_epochs = 0;
  const auto report = [&](const PeopleReport& now) {
    loss = now.loss;
    num_epochs += now.is_end_of_epoch ? 1 : 0;
  };
  const PeopleTrainerOptions options{.epochs = 40, .batch_size = 4};
  ASSERT_TRUE(TrainPeopleHead(head, *set, options, report, [] { return false; }));
  EXPECT_EQ(num_epochs, 40);
  EXPECT_LT(loss, 0.1);
  const CellScores scores = MeasureCells(head, *set);
  EXPECT_GT(scores.iou, 0.85);
  EXPECT_GT(scores.precision, 0.85);
  EXPECT_GT(scores.recall, 0.85);
}

TEST(PeopleMap, WhoAsksForTheEndGetsIt) {
  const OnnxModel model = MakeTinyDetector();
  const FeatureTaps taps = *FindFeatureTaps(model, "tiny.onnx");
  auto set = MakeSet(model, taps, 1);
  ASSERT_TRUE(set);
  PeopleHead head(taps.fine_channels, taps.coarse_channels);
  const torch::Tensor before = head->out->weight.detach().clone();
  EXPECT_FALSE(TrainPeopleHead(
      head, *set, {}, [](const PeopleReport&) {}, [] { return true; }));
  EXPECT_TRUE(head->out->weight.equal(before));
}

TEST(PeopleMap, CellsWithoutALabelDoNotCount) {
  const OnnxModel model = MakeTinyDetector();
  const FeatureTaps taps = *FindFeatureTaps(model, "tiny.onnx");
  auto set = MakeSet(model, taps, 1);
  ASSERT_TRUE(set);
  set->labels.fill_(kUnlabelledCell);
  PeopleHead head(taps.fine_channels, taps.coarse_channels);
  {
    const torch::NoGradGuard no_grad;
    head->out->bias.fill_(100);
  }
  const CellScores none = MeasureCells(head, *set);
  EXPECT_EQ(none.iou + none.precision + none.recall, 0);
  set->labels.select(0, 0).fill_(0);
  set->labels.select(0, 1).fill_(1);
  const CellScores half = MeasureCells(head, *set);
  EXPECT_EQ(half.recall, 1);
  EXPECT_EQ(half.precision, 0.5);
  EXPECT_EQ(half.iou, 0.5);
}

}  // namespace
}  // namespace yorb

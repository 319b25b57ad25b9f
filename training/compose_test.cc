// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/compose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pictures/test_folder.h"
#include "training/loader.h"
#include "training/people.h"
#include "training/test_shapes.h"

namespace yorb {
namespace {

const ClassTable kTable{{"square", "disc"}, {"", ""}};  // the other way round than in the pack

std::shared_ptr<const Composer> MakeComposer(int count) {
  const TestFolder folder;  // the mapping outlives the file's name
  const auto pack = MakeShapePack(folder.Path("shapes.pack"), count, 3);
  return std::make_shared<Composer>(std::vector<std::shared_ptr<const Pack>>{pack}, kTable);
}

/// The mean of green plus red minus twice blue: high on shapes, near nothing on the ground and on grey.
double Brightness(const cv::Mat& pixels, const SceneBox& box) {
  const cv::Rect area = cv::Rect(cv::Point2f(box.left, box.top), cv::Point2f(box.right, box.bottom)) &
                        cv::Rect(cv::Point(), pixels.size());
  const cv::Scalar mean = cv::mean(pixels(area));
  return mean[1] + mean[2] - 2 * mean[0];
}

TEST(Compose, LetterboxKeepsBoxesOnTheirThings) {
  const auto composer = MakeComposer(4);
  for (const cv::Size size : {cv::Size(320, 256), cv::Size(64, 160)}) {
    const Scene scene = composer->Letterbox(1, size);
    ASSERT_FALSE(scene.boxes.empty());
    for (const SceneBox& box : scene.boxes) EXPECT_GT(Brightness(scene.pixels, box), 100);
  }
}

TEST(Compose, AugmentedBoxesStayOnTheirThings) {
  const auto composer = MakeComposer(8);
  int num_boxes = 0;
  for (uint64_t i = 0; i < 60; ++i) {
    Random random(5, i);
    const Scene scene = composer->Compose(i % 8, {160, 128}, {}, random);
    for (const SceneBox& box : scene.boxes) {
      EXPECT_GE(box.left, 0);
      EXPECT_LE(box.right, 160);
      EXPECT_LE(box.bottom, 128);
      if (box.is_doubtful || std::min(box.width(), box.height()) < 8) continue;
      EXPECT_GT(Brightness(scene.pixels, box), 80);
      ++num_boxes;
    }
  }
  EXPECT_GT(num_boxes, 60);
}

TEST(Compose, ClassesGoByName) {
  const auto composer = MakeComposer(8);
  const std::vector<PackItem> items = MakeShapePictures(8, 3);
  for (size_t i = 0; i < items.size(); ++i) {
    const Scene scene = composer->Letterbox(i, {128, 96});
    ASSERT_EQ(scene.boxes.size(), items[i].boxes.size());
    for (size_t b = 0; b < scene.boxes.size(); ++b)
      EXPECT_EQ(scene.boxes[b].class_index, 1 - items[i].boxes[b].class_index);
  }
}

TEST(PastePeople, TheBoxIsWhatIsSeenOfThePerson) {
  cv::Mat cutout(60, 30, CV_8UC4, cv::Scalar(0, 0, 0, 0));
  cv::ellipse(cutout, {15, 30}, {12, 28}, 0, 0, 360, cv::Scalar(200, 60, 60, 255), cv::FILLED);
  PeopleOptions options;
  options.share = options.most = 1;
  options.occluded_share = 0;
  int num_people = 0;
  for (uint64_t i = 0; i < 40; ++i) {
    Scene scene{cv::Mat(128, 160, CV_8UC3, cv::Scalar::all(0)), {}, {}};
    Random random(9, i);
    PastePeople({cutout}, 4, options, scene, random);
    cv::Mat grey, seen;
    cv::cvtColor(scene.pixels, grey, cv::COLOR_BGR2GRAY);
    if (scene.boxes.empty()) continue;
    const SceneBox& box = scene.boxes.front();
    const cv::Rect drawn = cv::boundingRect(grey > 12);
    EXPECT_EQ(box.class_index, 4);
    EXPECT_NEAR(box.left, drawn.x, 2);
    EXPECT_NEAR(box.bottom, drawn.br().y, 2);
    ++num_people;
  }
  EXPECT_GT(num_people, 20);
}

TEST(Loader, AResumedTrainingSeesTheSamePictures) {
  const auto composer = MakeComposer(10);
  LoaderOptions options;
  options.batch_size = 4;
  const auto size = [](int64_t) { return cv::Size(96, 64); };
  Loader first(composer, {}, kTable, options, size), second(composer, {}, kTable, options, size);
  for (int64_t step = 0; step < 5; ++step) first.Make(step);
  const Batch a = first.Make(5), b = second.Make(5);
  EXPECT_TRUE(torch::equal(a.pictures, b.pictures));
  EXPECT_EQ(a.targets.size(), b.targets.size());
}

}  // namespace
}  // namespace yorb

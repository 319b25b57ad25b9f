// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_compose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "pictures/test_folder.h"

namespace yorb {
namespace {

constexpr int kGround = 90;

/// A grey picture with a bright disc for a person, and its mask.
MaskedPicture MakeMasked(const cv::Point& middle, int radius) {
  MaskedPicture picture{cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(kGround)),
                        cv::Mat(120, 160, CV_8U, cv::Scalar(kMaskNobody))};
  cv::circle(picture.pixels, middle, radius, cv::Scalar::all(250), cv::FILLED);
  cv::circle(picture.people_mask, middle, radius, cv::Scalar(kMaskPerson), cv::FILLED);
  return picture;
}

cv::Mat PersonOf(const cv::Mat& mask) { return mask == kMaskPerson; }

/// The share of the pixels in which two masks agree.
double Agreement(const cv::Mat& a, const cv::Mat& b) {
  return 1 - cv::countNonZero(a != b) / static_cast<double>(a.total());
}

TEST(ComposeSingle, TheMaskGoesWithThePicture) {
  const MaskedPicture source = MakeMasked({90, 50}, 25);
  PackedPicture picture;
  picture.pixels = source.pixels;
  int num_seen = 0;
  for (uint64_t i = 0; i < 20; ++i) {
    Random random(1, i);
    const Scene scene = ComposeSingle(picture, source.people_mask, {160, 128}, {}, random);
    cv::Mat grey;
    cv::cvtColor(scene.pixels, grey, cv::COLOR_BGR2GRAY);
    EXPECT_GT(Agreement(grey > 170, PersonOf(scene.people_mask)), 0.98);
    num_seen += cv::countNonZero(scene.people_mask) > 0 ? 1 : 0;
  }
  EXPECT_GT(num_seen, 10);
}

TEST(PastePeople, PaintsTheMaskWhereThePictureChanges) {
  const std::vector<cv::Mat> cutouts{cv::Mat(60, 30, CV_8UC4, cv::Scalar(220, 240, 230, 255))};
  PeopleOptions options{.share = 1};
  for (uint64_t i = 0; i < 20; ++i) {
    options.occluded_share = i < 10 ? 0 : 0.5;
    Random random(2, i);
    Scene scene{cv::Mat(128, 160, CV_8UC3, cv::Scalar::all(kGround)), {}, {}};
    scene.people_mask = cv::Mat(128, 160, CV_8U, cv::Scalar(kMaskUnknown));
    PastePeople(cutouts, 0, options, scene, random);
    cv::Mat is_ground;
    cv::inRange(scene.pixels, cv::Scalar::all(kGround), cv::Scalar::all(kGround), is_ground);
    const cv::Mat is_person = PersonOf(scene.people_mask);
    EXPECT_EQ(cv::countNonZero(is_ground & is_person), 0);  // plates hide people in the mask, too
    if (i < 10) {
      EXPECT_GT(Agreement(~is_ground, is_person), 0.98);
    }
  }
}

TEST(FindPlainScenes, SortsByWhatBoxesSay) {
  const TestFolder folder;
  folder.Write("classes.txt", "chair\nperson\n");
  for (const std::string name : {"empty", "peopled", "doubtful"})
    folder.WritePicture("images/a/" + name + ".png", TestColour(1));
  folder.Write("labels/a/empty.txt", "0 .5 .5 .2 .2\n");
  folder.Write("labels/a/peopled.txt", "1 .25 .5 .25 .5\n");
  folder.Write("labels_teacher/a/doubtful.txt", "1 .5 .5 .2 .2 .9\n");
  const auto scenes = FindPlainScenes({folder.Path("images")});
  ASSERT_TRUE(scenes) << scenes.error().message;
  ASSERT_EQ(scenes->empty.size(), 1u);
  EXPECT_THAT(scenes->empty[0].file, testing::EndsWith("empty.png"));
  ASSERT_EQ(scenes->peopled.size(), 1u);
  const auto picture = ReadPlainScene(scenes->peopled[0]);
  ASSERT_TRUE(picture) << picture.error().message;
  cv::Mat wanted(kTestHeight, kTestWidth, CV_8U, cv::Scalar(kMaskNobody));
  wanted(cv::Rect(8 - 3, 12 - 3, 16 + 6, 24 + 6)).setTo(kMaskUnknown);
  EXPECT_EQ(Agreement(picture->people_mask, wanted), 1);
}

TEST(FindPlainScenes, PicturesWithoutAPersonInTheirClassesAreRefused) {
  const TestFolder folder;
  folder.Write("classes.txt", "chair\n");
  folder.WritePicture("images/a.png", TestColour(1));
  EXPECT_FALSE(FindPlainScenes({folder.Path("images")}));
}

TEST(MaskedPictures, AreFoundWithTheirMasksAndCutOut) {
  const TestFolder folder;
  const MaskedPicture picture = MakeMasked({60, 60}, 30);
  cv::circle(picture.people_mask, {140, 20}, 5, cv::Scalar(kMaskPerson), cv::FILLED);  // too small
  folder.WritePicture("images/set_1.png", picture.pixels);
  EXPECT_FALSE(FindMaskedFiles(folder.Path()));
  folder.WritePicture("masks/set_1.png", picture.people_mask);
  const auto files = FindMaskedFiles(folder.Path());
  ASSERT_TRUE(files) << files.error().message;
  const auto cutouts = CutOutPeople(*files);
  ASSERT_TRUE(cutouts) << cutouts.error().message;
  ASSERT_EQ(cutouts->size(), 1u);
  EXPECT_EQ(cutouts->front().type(), CV_8UC4);
  EXPECT_EQ(cutouts->front().size(), cv::Size(61, 61));
}

TEST(PeopleComposer, GivesTheSamePictureForTheSameChance) {
  const TestFolder folder;
  const MaskedPicture picture = MakeMasked({60, 60}, 30);
  folder.WritePicture("images/set_1.png", picture.pixels);
  folder.WritePicture("masks/set_1.png", picture.people_mask);
  const auto files = FindMaskedFiles(folder.Path());
  ASSERT_TRUE(files);
  const PeopleComposer composer(*files, {}, {}, {});
  Random one(3), same(3);
  const auto a = composer.Compose({96, 64}, one), b = composer.Compose({96, 64}, same);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->pixels.size(), cv::Size(96, 64));
  EXPECT_EQ(cv::norm(a->pixels, b->pixels, cv::NORM_INF), 0);
  EXPECT_EQ(Agreement(a->people_mask, b->people_mask), 1);
}

TEST(LetterboxMasked, NothingIsKnownOfTheBars) {
  const Scene scene = LetterboxMasked(MakeMasked({80, 60}, 20), {160, 160});
  EXPECT_EQ(scene.people_mask.at<uint8_t>(5, 5), kMaskUnknown);
  EXPECT_EQ(scene.people_mask.at<uint8_t>(25, 5), kMaskNobody);
  EXPECT_EQ(scene.people_mask.at<uint8_t>(80, 80), kMaskPerson);
}

}  // namespace
}  // namespace yorb

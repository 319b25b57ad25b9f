// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/learn_vocabulary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "features/test_pictures.h"
#include "pictures/picture_file.h"
#include "pictures/test_folder.h"
#include "places/place_index.h"
#include "places/vocabulary_io.h"
#include "runs/find_vocabulary.h"

namespace yorb {
namespace {

using testing::HasSubstr;

/// The folder with so many pictures in it.
void WritePictures(const TestFolder& folder, uint64_t count) {
  for (uint64_t i = 0; i < count; ++i)
    folder.WritePicture("pictures/" + std::to_string(10 + i) + ".png", RectanglesPicture(200, 150, i));
}

LearningOptions SmallOptions() {
  LearningOptions options;
  options.features.wanted = 200;
  options.training.branching = 5, options.training.levels = 3, options.training.least_rows = 5;
  return options;
}

TEST(LearnVocabulary, LearnsFromAFolderTheSameWithAnyNumberOfThreads) {
  const TestFolder folder;
  WritePictures(folder, 6);
  folder.Write("pictures/broken.png", "no picture");
  LearningOptions options = SmallOptions();
  size_t last = 0, all = 0;
  LearningHooks hooks;
  hooks.on_pictures = [&](size_t done, size_t of) { last = done, all = of; };
  const auto one = LearnVocabulary({folder.Path("pictures")}, options, hooks);
  ASSERT_TRUE(one) << one.error().message;
  EXPECT_EQ(one->num_pictures, 6u);
  EXPECT_GT(one->num_points, 600u);
  EXPECT_GT(one->vocabulary->num_words(), 60u);
  EXPECT_EQ(last, 7u);
  EXPECT_EQ(all, 7u);
  options.training.num_threads = 3;
  const auto three = LearnVocabulary({folder.Path("pictures")}, options);
  ASSERT_TRUE(three);
  EXPECT_EQ(three->vocabulary->digest(), one->vocabulary->digest());
}

TEST(LearnVocabulary, OfTooManyPicturesEvenlySpreadOnesAreTaken) {
  const TestFolder folder;
  WritePictures(folder, 9);
  LearningOptions options = SmallOptions();
  options.most_pictures = 5;
  const auto all = LearnVocabulary({folder.Path("pictures")}, options);
  ASSERT_TRUE(all) << all.error().message;
  EXPECT_EQ(all->num_pictures, 5u);  // every second of nine
  for (const uint64_t i : {1, 3, 5, 7})
    std::filesystem::remove(folder.Path("pictures/" + std::to_string(10 + i) + ".png"));
  const auto even = LearnVocabulary({folder.Path("pictures")}, options);
  ASSERT_TRUE(even);
  EXPECT_EQ(even->vocabulary->digest(), all->vocabulary->digest());
}

TEST(LearnVocabulary, RefusesWhatIsNotThereAndStopsWhenAsked) {
  const TestFolder folder;
  WritePictures(folder, 2);
  EXPECT_FALSE(LearnVocabulary({folder.Path("pictures"), folder.Path("missing")}, SmallOptions()));
  LearningHooks hooks;
  hooks.should_stop = [] { return true; };
  EXPECT_FALSE(LearnVocabulary({folder.Path("pictures")}, SmallOptions(), hooks));
}

TEST(FindVocabulary, TakesTheNamedOneElseTheInstalledOne) {
  const TestFolder folder;
  folder.Write("spoilt.txt", "k=10 L=2\n");
  PlacesOptions options;
  const auto installed = FindVocabulary(options);
  ASSERT_TRUE(installed) << installed.error().message;
  ASSERT_NE(*installed, nullptr);
  EXPECT_GT((*installed)->num_words(), 100000u);
  options.vocabulary = folder.Path("spoilt.txt");
  const auto spoilt = FindVocabulary(options);
  ASSERT_FALSE(spoilt);
  EXPECT_THAT(spoilt.error().message, HasSubstr("spoilt.txt, line 1"));
}

/// The bag of a picture of room_loop, by its number.
Bag BagOfRoom(const std::string& folder, const Vocabulary& vocabulary, int number) {
  std::string name = std::to_string(number);
  name.insert(0, 5 - name.size(), '0');
  FeatureOptions options;
  options.over_extraction = 1;
  const std::string path = folder + "/" + name + ".jpg";
  const auto picture = ToColourAndGrey(ReadPictureFile(path).pixels, path);
  return vocabulary.Describe(OrbExtractor(options).Extract(picture->grey).descriptors);
}

TEST(FindVocabulary, TheInstalledOneFindsTheRoomThatIsSeenAgain) {
  const std::string folder = DataFolder("room_loop/rgb");
  if (folder.empty()) GTEST_SKIP() << "skipped: no data";
  const VocabularyPtr vocabulary = *FindVocabulary({});
  PlaceIndex index;
  for (int number = 3; number < 300; number += 2)
    index.Add(static_cast<uint32_t>(number), std::make_shared<const Bag>(BagOfRoom(folder, *vocabulary, number)));
  for (const int number : {359, 362}) {  // 244 to 256 show the same place
    const auto found = index.Query(BagOfRoom(folder, *vocabulary, number), 5);
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const Recalled& recalled) {
      return recalled.place >= 240 && recalled.place <= 260;
    })) << number;
  }
}

}  // namespace
}  // namespace yorb

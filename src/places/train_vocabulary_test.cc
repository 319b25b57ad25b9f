// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/train_vocabulary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "features/hamming.h"
#include "places/cluster.h"
#include "places/test_descriptors.h"

namespace yorb {
namespace {

Descriptor SlowMajority(const std::vector<Descriptor>& rows) {
  Descriptor majority{};
  for (size_t bit = 0; bit < 256; ++bit) {
    size_t count = 0;
    for (const Descriptor& row : rows) count += (row[bit / 64] >> (bit % 64)) & 1;
    if (2 * count > rows.size()) majority[bit / 64] |= uint64_t{1} << (bit % 64);
  }
  return majority;
}

TEST(Cluster, MajorityIsCountedBitByBit) {
  for (const size_t count : {1, 2, 3, 62, 63, 64, 65, 126, 127, 1000}) {
    const std::vector<Descriptor> rows = RandomDescriptors(count, count);
    EXPECT_EQ(MajorityOf(rows.data(), count), SlowMajority(rows)) << count;
  }
  const std::vector<Descriptor> alike(500, RandomDescriptors(1, 4)[0]);
  EXPECT_EQ(MajorityOf(alike.data(), alike.size()), alike[0]);
}

TEST(Cluster, FindsKindsThatLieFarApart) {
  const std::vector<Descriptor> kinds = RandomDescriptors(8, 11);
  Random random(1);
  std::vector<Descriptor> rows;
  for (size_t i = 0; i < 800; ++i) rows.push_back(WithNoise(kinds[i % 8], 2, random));
  const Clusters clusters = ClusterRows(rows.data(), rows.size(), {8, 20}, random);
  EXPECT_EQ(std::set<Descriptor>(clusters.centres.begin(), clusters.centres.end()),
            std::set<Descriptor>(kinds.begin(), kinds.end()));
  EXPECT_EQ(clusters.sizes, std::vector<size_t>(8, 100));
}

TEST(Cluster, SortsRowsByTheirNearestCentre) {
  std::vector<Descriptor> rows = RandomDescriptors(500, 2);
  const std::multiset<Descriptor> before(rows.begin(), rows.end());
  Random random(7);
  const Clusters clusters = ClusterRows(rows.data(), rows.size(), {10, 5}, random);
  EXPECT_EQ(std::multiset<Descriptor>(rows.begin(), rows.end()), before);
  size_t row = 0;
  for (size_t cluster = 0; cluster < clusters.centres.size(); ++cluster) {
    for (size_t i = 0; i < clusters.sizes[cluster]; ++i, ++row) {
      for (const Descriptor& other : clusters.centres)
        EXPECT_LE(HammingDistance(rows[row], clusters.centres[cluster]), HammingDistance(rows[row], other));
    }
  }
  EXPECT_EQ(row, rows.size());
}

TEST(Cluster, RowsThatAreAlikeGiveNoMoreClustersThanKinds) {
  std::vector<Descriptor> rows(50, RandomDescriptors(1, 3)[0]);
  rows[20] = RandomDescriptors(1, 4)[0];
  Random random(1);
  EXPECT_EQ(ClusterRows(rows.data(), rows.size(), {10, 5}, random).centres.size(), 2u);
  EXPECT_TRUE(ClusterRows(rows.data(), 0, {10, 5}, random).centres.empty());
}

TEST(TrainVocabulary, SameBitsWithAnyNumberOfThreadsOtherBitsWithAnotherSeed) {
  const auto pictures = PicturesOfThings(20, 100, 1);
  TrainingOptions options;
  options.branching = 8, options.levels = 3, options.least_rows = 4;
  const auto one = TrainVocabulary(pictures, options);
  ASSERT_TRUE(one);
  options.num_threads = 3;
  EXPECT_EQ((*TrainVocabulary(pictures, options))->digest(), (*one)->digest());
  options.seed = 2;
  EXPECT_NE((*TrainVocabulary(pictures, options))->digest(), (*one)->digest());
}

TEST(TrainVocabulary, WeighsRareWordsMore) {
  // Two kinds of points in every picture, two others in one of them; a point counts for its own kind and the nearest.
  const uint64_t all = ~uint64_t{0};
  const std::vector<Descriptor> kinds = {{0, 0, 0, 0}, {0, 0, 0, 1}, {all, all, all, all}, {all, all, all, all - 1}};
  std::vector<std::vector<Descriptor>> pictures(10);
  for (auto& picture : pictures) picture = {kinds[0], kinds[0], kinds[1], kinds[1]};
  pictures[4].insert(pictures[4].end(), {kinds[2], kinds[3]});
  TrainingOptions options;
  options.branching = 4, options.levels = 1, options.least_rows = 2;
  const auto vocabulary = TrainVocabulary(pictures, options);
  ASSERT_TRUE(vocabulary);
  const auto weight_of = [&](size_t kind) {
    return (*vocabulary)->tree().word_weights[(*vocabulary)->WordsOf(kinds[kind])[0]];
  };
  EXPECT_NEAR(weight_of(0), std::log1p(1.0), 1e-6);
  EXPECT_NEAR(weight_of(1), std::log1p(1.0), 1e-6);
  EXPECT_NEAR(weight_of(2), std::log1p(10.0), 1e-6);
  EXPECT_NEAR(weight_of(3), std::log1p(10.0), 1e-6);
}

TEST(TrainVocabulary, FindsAPlaceSeenAgain) {
  const VocabularyPtr vocabulary = SmallVocabulary();
  const auto places = PicturesOfThings(30, 100, 6);
  std::vector<Bag> bags;
  for (const auto& place : places) bags.push_back(vocabulary->Describe(place));
  for (size_t i = 0; i < places.size(); ++i) {
    const Bag again = vocabulary->Describe(SeenAgain(places[i], 12, i));
    const auto best = std::max_element(bags.begin(), bags.end(), [&](const Bag& a, const Bag& b) {
      return Similarity(again, a) < Similarity(again, b);
    });
    EXPECT_EQ(best - bags.begin(), static_cast<std::ptrdiff_t>(i));
  }
}

TEST(TrainVocabulary, TellsHowFarItIsAndStopsWhenAsked) {
  const auto pictures = PicturesOfThings(10, 100, 1);
  TrainingOptions options;
  options.branching = 4, options.levels = 4, options.least_rows = 2;
  size_t last = 0, all = 0;
  TrainingHooks hooks;
  hooks.progress = [&](size_t num_done, size_t num_all) {
    EXPECT_GE(num_done, last);
    last = num_done, all = num_all;
  };
  ASSERT_TRUE(TrainVocabulary(pictures, options, hooks));
  EXPECT_EQ(all, 4000u);
  EXPECT_LE(last, all);
  EXPECT_GE(last, all * 9 / 10);
  hooks.should_stop = [&] { return true; };
  EXPECT_FALSE(TrainVocabulary(pictures, options, hooks));
}

TEST(TrainVocabulary, RefusesWhatCannotBeLearntFrom) {
  EXPECT_FALSE(TrainVocabulary({}, {}));
  EXPECT_FALSE(TrainVocabulary({{}, {}}, {}));
  EXPECT_FALSE(TrainVocabulary({std::vector<Descriptor>(100, Descriptor{1, 2, 3, 4})}, {}));
  TrainingOptions options;
  options.branching = 1;
  EXPECT_FALSE(TrainVocabulary(PicturesOfThings(2, 100, 1), options));
  options.branching = 10, options.levels = 9;
  EXPECT_FALSE(TrainVocabulary(PicturesOfThings(2, 100, 1), options));
}

}  // namespace
}  // namespace yorb

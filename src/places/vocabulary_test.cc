// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/vocabulary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "features/hamming.h"
#include "places/test_descriptors.h"

namespace yorb {
namespace {

/// A tree of two levels: the root's two children, of which the first has two.
VocabularyTree SmallTree() {
  const uint64_t all = ~uint64_t{0};
  VocabularyTree tree;
  tree.branching = 2, tree.levels = 2;
  tree.num_children = {2, 2, 0, 0, 0};
  tree.centres = {{}, {0, 0, 0, 0}, {all, all, all, all}, {0, 0, 0, 0}, {all, 0, 0, 0}};
  tree.word_weights = {1.f, 2.f, 3.f};
  return tree;
}

double SlowSimilarity(const Bag& a, const Bag& b) {
  std::map<uint32_t, double> difference;
  for (const WordWeight& entry : a.words) difference[entry.word] += entry.weight;
  for (const WordWeight& entry : b.words) difference[entry.word] -= entry.weight;
  double sum = 0;
  for (const auto& [word, value] : difference) sum += std::abs(value);
  return 1 - sum / 2;
}

TEST(Bag, AddsUpWordsSortsThemAndSumsToOne) {
  const Bag bag = BagOf({{7, 1.f}, {3, 2.f}, {7, 1.f}, {9, 0.f}});
  ASSERT_EQ(bag.words.size(), 2u);
  EXPECT_EQ(bag.words[0].word, 3u);
  EXPECT_EQ(bag.words[1].word, 7u);
  EXPECT_FLOAT_EQ(bag.words[0].weight, 0.5f);
  EXPECT_FLOAT_EQ(bag.words[1].weight, 0.5f);
}

TEST(Bag, SimilarityIsOneMinusHalfTheDistance) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const auto a = RandomBag(200, 300, random), b = RandomBag(150, 300, random);
    EXPECT_NEAR(Similarity(*a, *b), SlowSimilarity(*a, *b), 1e-6);
    EXPECT_EQ(Similarity(*a, *b), Similarity(*b, *a));
    EXPECT_NEAR(Similarity(*a, *a), 1, 1e-6);
  }
}

TEST(Bag, NothingIsLikeAnEmptyBag) {
  EXPECT_EQ(Similarity({}, {}), 0);
  EXPECT_EQ(Similarity({}, BagOf({{1, 1.f}})), 0);
  EXPECT_TRUE(BagOf({{1, 0.f}}).words.empty());
}

TEST(Vocabulary, CountsForTheTwoNearestWords) {
  const auto vocabulary = Vocabulary::Make(SmallTree());
  ASSERT_TRUE(vocabulary);
  EXPECT_EQ((*vocabulary)->num_words(), 3u);
  const uint64_t all = ~uint64_t{0};
  // Words are numbered breadth first: 0 has all bits, 1 none, 2 a quarter.
  EXPECT_EQ((*vocabulary)->WordsOf({all, all, all, 1}), (NearestWords{0, 2}));
  EXPECT_EQ((*vocabulary)->WordsOf({1, 0, 0, 0}), (NearestWords{1, 2}));
  EXPECT_EQ((*vocabulary)->WordsOf({all, 7, 0, 0}), (NearestWords{2, 1}));
  const Bag bag = (*vocabulary)->Describe({{all, all, all, 1}, {all, 7, 0, 0}});
  ASSERT_EQ(bag.words.size(), 3u);
  EXPECT_FLOAT_EQ(bag.words[0].weight, 1.f / 9);
  EXPECT_FLOAT_EQ(bag.words[1].weight, 2.f / 9);
  EXPECT_FLOAT_EQ(bag.words[2].weight, 6.f / 9);
  EXPECT_TRUE((*vocabulary)->Describe({}).words.empty());
}

/// The same way down with sorted lists.
NearestWords SlowWords(const VocabularyTree& tree, const Descriptor& descriptor) {
  std::vector<size_t> first_child, number;
  size_t next_child = 1, next_word = 0;
  for (const uint8_t count : tree.num_children) {
    first_child.push_back(next_child);
    number.push_back(count == 0 ? next_word++ : 0);
    next_child += count;
  }
  std::vector<std::pair<int, size_t>> nearest = {{0, 0}};
  for (int level = 0; level < tree.levels; ++level) {
    std::vector<std::pair<int, size_t>> below;
    for (const auto& [distance, node] : nearest) {
      if (tree.num_children[node] == 0) below.push_back({distance, node});
      for (size_t i = 0; i < tree.num_children[node]; ++i)
        below.push_back({HammingDistance(descriptor, tree.centres[first_child[node] + i]), first_child[node] + i});
    }
    std::stable_sort(below.begin(), below.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    below.resize(std::min<size_t>(4, below.size()));
    nearest = below;
  }
  return {static_cast<uint32_t>(number[nearest[0].second]), static_cast<uint32_t>(number[nearest[1].second])};
}

TEST(Vocabulary, FollowsTheFourNearestNodes) {
  const VocabularyPtr vocabulary = SmallVocabulary();
  for (const Descriptor& descriptor : RandomDescriptors(300, 17))
    EXPECT_EQ(vocabulary->WordsOf(descriptor), SlowWords(vocabulary->tree(), descriptor));
}

TEST(Vocabulary, DigestTellsEveryPartApart) {
  const uint64_t first = (*Vocabulary::Make(SmallTree()))->digest();
  EXPECT_EQ(first, (*Vocabulary::Make(SmallTree()))->digest());
  VocabularyTree tree = SmallTree();
  tree.centres[3][2] ^= 1;
  EXPECT_NE(first, (*Vocabulary::Make(tree))->digest());
  tree = SmallTree();
  tree.word_weights[1] = 2.0001f;
  EXPECT_NE(first, (*Vocabulary::Make(tree))->digest());
  tree = SmallTree();
  tree.levels = 3;
  EXPECT_NE(first, (*Vocabulary::Make(tree))->digest());
}

TEST(Vocabulary, WhatIsNoTreeIsRefused) {
  const auto refused = [](auto spoil) {
    VocabularyTree tree = SmallTree();
    spoil(tree);
    return !Vocabulary::Make(tree).ok();
  };
  EXPECT_FALSE(refused([](VocabularyTree&) {}));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree.num_children = {2, 0, 0, 0, 0}; }));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree.num_children = {2, 2, 2, 0, 0}; }));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree.num_children = {0, 4, 0, 0, 0}; }));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree.centres.pop_back(); }));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree.word_weights.pop_back(); }));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree.word_weights[0] = -1; }));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree.word_weights[0] = std::numeric_limits<float>::quiet_NaN(); }));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree.levels = 1; }));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree.branching = 0; }));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree.word_weights = {0, 0, 0}; }));
  EXPECT_TRUE(refused([](VocabularyTree& tree) { tree = {}; }));
}

}  // namespace
}  // namespace yorb

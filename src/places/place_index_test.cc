// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/place_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "places/test_descriptors.h"

namespace yorb {
namespace {

using Places = std::map<uint32_t, std::shared_ptr<const Bag>>;

/// Every place compared with the bag, one by one.
std::vector<Recalled> SlowQuery(const Places& places, const Bag& bag, size_t max_count) {
  std::vector<Recalled> found;
  for (const auto& [place, other] : places) {
    Recalled recalled{place, Similarity(bag, *other), 0};
    for (const WordWeight& a : bag.words) {
      for (const WordWeight& b : other->words) recalled.shared_words += a.word == b.word;
    }
    if (recalled.shared_words > 0) found.push_back(recalled);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Recalled& a, const Recalled& b) { return a.similarity > b.similarity; });
  found.resize(std::min(found.size(), max_count));
  return found;
}

void ExpectSame(const std::vector<Recalled>& got, const std::vector<Recalled>& wanted) {
  ASSERT_EQ(got.size(), wanted.size());
  for (size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].place, wanted[i].place);
    EXPECT_EQ(got[i].similarity, wanted[i].similarity);
    EXPECT_EQ(got[i].shared_words, wanted[i].shared_words);
  }
}

TEST(PlaceIndex, AnswersAsComparingAllPlacesWhileTheyComeAndGo) {
  Random random(1);
  PlaceIndex index;
  Places places;
  for (int step = 0; step < 300; ++step) {
    const uint32_t place = random.Below(60);
    if (places.count(place) > 0) {
      index.Remove(place);
      places.erase(place);
    } else {
      places[place] = RandomBag(40, 500, random);
      index.Add(place, places[place]);
    }
    const auto bag = RandomBag(50, 600, random);
    ExpectSame(index.Query(*bag, 10), SlowQuery(places, *bag, 10));
    ASSERT_EQ(index.size(), places.size());
    ASSERT_EQ(index.Contains(place), places.count(place) > 0);
    ASSERT_EQ(index.Find(place) != nullptr, places.count(place) > 0);
  }
}

TEST(PlaceIndex, OrderOfAddingDoesNotCount) {
  Random random(2);
  std::vector<std::shared_ptr<const Bag>> bags;
  for (int i = 0; i < 50; ++i) bags.push_back(RandomBag(100, 200, random));
  PlaceIndex up, down;
  for (uint32_t i = 0; i < 50; ++i) up.Add(i, bags[i]);
  for (uint32_t i = 50; i-- > 0;) down.Add(i, bags[i]);
  ExpectSame(up.Query(*bags[7], 50), down.Query(*bags[7], 50));
}

TEST(PlaceIndex, EqualPlacesComeByNumber) {
  Random random(3);
  const auto bag = RandomBag(20, 100, random);
  PlaceIndex index;
  for (const uint32_t place : {9, 2, 7}) index.Add(place, bag);
  const auto found = index.Query(*bag, 2);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].place, 2u);
  EXPECT_EQ(found[1].place, 7u);
  EXPECT_NEAR(found[0].similarity, 1, 1e-6);
}

TEST(PlaceIndex, EmptyOnesAnswerNothing) {
  Random random(4);
  PlaceIndex index;
  EXPECT_TRUE(index.Query(*RandomBag(20, 100, random), 5).empty());
  index.Add(3, std::make_shared<const Bag>());
  EXPECT_TRUE(index.Query({}, 5).empty());
  EXPECT_TRUE(index.Contains(3));
  EXPECT_EQ(index.Find(4), nullptr);
  index.Remove(4);
  EXPECT_EQ(index.size(), 1u);
}

}  // namespace
}  // namespace yorb

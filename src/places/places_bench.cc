// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Describing a picture and asking for its place, at the sizes that a long run reaches.
#include <benchmark/benchmark.h>

#include "places/place_index.h"
#include "places/test_descriptors.h"

namespace yorb {
namespace {

constexpr size_t kPoints = 1000;
constexpr uint32_t kPlaces = 2000;

/// A full tree of 10 branches and 5 levels, as the shipped vocabulary's, with centres drawn by chance.
const Vocabulary& BigVocabulary() {
  static const VocabularyPtr vocabulary = [] {
    VocabularyTree tree;
    for (size_t level = 0, nodes = 1; level <= 5; ++level, nodes *= 10)
      tree.num_children.insert(tree.num_children.end(), nodes, level < 5 ? 10 : 0);
    tree.centres = RandomDescriptors(tree.num_children.size(), 1);
    tree.word_weights.assign(100000, 1.f);
    return *Vocabulary::Make(std::move(tree));
  }();
  return *vocabulary;
}

void BM_Describe(benchmark::State& state) {
  const std::vector<Descriptor> descriptors = RandomDescriptors(kPoints, 2);
  for (auto _ : state) benchmark::DoNotOptimize(BigVocabulary().Describe(descriptors).words.data());
}
BENCHMARK(BM_Describe)->Unit(benchmark::kMillisecond);

/// Words as uneven as those of real pictures: a product of two even draws prefers the low ones.
std::shared_ptr<const Bag> UnevenBag(Random& random) {
  std::vector<WordWeight> words;
  for (size_t i = 0; i < kPoints; ++i)
    words.push_back({static_cast<uint32_t>(random.Uniform() * random.Uniform() * random.Uniform() * 1e5), 1.f});
  return std::make_shared<const Bag>(BagOf(std::move(words)));
}

void BM_Query(benchmark::State& state) {
  Random random(1);
  PlaceIndex index;
  for (uint32_t place = 0; place < kPlaces; ++place) index.Add(place, UnevenBag(random));
  const auto bag = UnevenBag(random);
  for (auto _ : state) benchmark::DoNotOptimize(index.Query(*bag, 20).data());
}
BENCHMARK(BM_Query)->Unit(benchmark::kMillisecond);

void BM_AddAndRemove(benchmark::State& state) {
  Random random(1);
  PlaceIndex index;
  for (uint32_t place = 0; place < kPlaces; ++place) index.Add(place, UnevenBag(random));
  const auto bag = UnevenBag(random);
  for (auto _ : state) {
    index.Add(kPlaces, bag);
    index.Remove(kPlaces);
  }
}
BENCHMARK(BM_AddAndRemove)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Describing a picture and asking for its place, at the sizes that a long run reaches.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "places/place_index.h"
#include "places/test_descriptors.h"
#include "places/vocabulary_io.h"

namespace yorb {
namespace {

constexpr size_t kPoints = 1000;
constexpr uint32_t kPlaces = 2000;

/// A full tree of 20 branches and 4 levels, as the shipped vocabulary's, with centres drawn by chance.
const Vocabulary& BigVocabulary() {
  static const VocabularyPtr vocabulary = [] {
    VocabularyTree tree;
    for (size_t level = 0, nodes = 1; level <= 4; ++level, nodes *= 20)
      tree.num_children.insert(tree.num_children.end(), nodes, level < 4 ? 20 : 0);
    tree.centres = RandomDescriptors(tree.num_children.size(), 1);
    tree.word_weights.assign(160000, 1.f);
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
  for (size_t i = 0; i < 2 * kPoints; ++i)
    words.push_back({static_cast<uint32_t>(random.Uniform() * random.Uniform() * random.Uniform() * 1.6e5), 1.f});
  return std::make_shared<const Bag>(BagOf(std::move(words)));
}

void BM_Load(benchmark::State& state) {
  const std::string path = (std::filesystem::temp_directory_path() / "yorb_places_bench.yvoc").string();
  if (!WriteVocabulary(BigVocabulary(), path)) return state.SkipWithError("cannot write the vocabulary");
  for (auto _ : state) benchmark::DoNotOptimize((*ReadVocabulary(path))->digest());
  std::filesystem::remove(path);
}
BENCHMARK(BM_Load)->Unit(benchmark::kMillisecond);

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

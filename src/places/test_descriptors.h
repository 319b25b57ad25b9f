// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/random.h"
#include "features/keypoint.h"
#include "places/bag.h"
#include "places/train_vocabulary.h"
#include "places/vocabulary.h"

namespace yorb {

inline Descriptor RandomDescriptor(Random& random) {
  return {random.Next(), random.Next(), random.Next(), random.Next()};
}

/// The descriptor with so many bits, drawn anew each, turned.
inline Descriptor WithNoise(Descriptor descriptor, int num_bits, Random& random) {
  for (int i = 0; i < num_bits; ++i) {
    const uint32_t bit = random.Below(256);
    descriptor[bit / 64] ^= uint64_t{1} << (bit % 64);
  }
  return descriptor;
}

inline std::vector<Descriptor> RandomDescriptors(size_t count, uint64_t seed) {
  Random random(seed);
  std::vector<Descriptor> rows(count);
  for (Descriptor& row : rows) row = RandomDescriptor(random);
  return rows;
}

/// Another look at a picture: every descriptor with noise.
inline std::vector<Descriptor> SeenAgain(const std::vector<Descriptor>& picture, int num_bits, uint64_t seed) {
  Random random(seed, 1);
  std::vector<Descriptor> rows;
  for (const Descriptor& row : picture) rows.push_back(WithNoise(row, num_bits, random));
  return rows;
}

/// Pictures of things drawn from a common stock of kinds, as corners of real pictures are of kinds.
inline std::vector<std::vector<Descriptor>> PicturesOfThings(size_t num_pictures, size_t num_points, uint64_t seed) {
  const std::vector<Descriptor> kinds = RandomDescriptors(num_points * 4, 99);
  Random random(seed, 2);
  std::vector<std::vector<Descriptor>> pictures(num_pictures);
  for (auto& picture : pictures) {
    for (size_t i = 0; i < num_points; ++i)
      picture.push_back(WithNoise(kinds[random.Below(static_cast<uint32_t>(kinds.size()))], 20, random));
  }
  return pictures;
}

/// A small trained vocabulary.
inline VocabularyPtr SmallVocabulary() {
  TrainingOptions options;
  options.branching = 6, options.levels = 3, options.least_rows = 4;
  return *TrainVocabulary(PicturesOfThings(20, 100, 5), options);
}

/// A bag of so many words of so many.
inline std::shared_ptr<const Bag> RandomBag(size_t num_points, uint32_t num_words, Random& random) {
  std::vector<WordWeight> words;
  for (size_t i = 0; i < num_points; ++i)
    words.push_back({random.Below(num_words), static_cast<float>(random.Uniform(1, 8))});
  return std::make_shared<const Bag>(BagOf(std::move(words)));
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace yorb {

/// A visual word and how much it says about a picture.
struct WordWeight {
  uint32_t word = 0;
  float weight = 0;
};

/// A picture as the words that are in it: how often each is there times how rare it is elsewhere (tf-idf). By rising
/// word, each once, all weights above 0, and their sum 1; empty where the picture says nothing.
struct Bag {
  std::vector<WordWeight> words;
};

/// The bag of words of these kinds, in any order, where a word may stand more than once: its weights are added up.
Bag BagOf(std::vector<WordWeight> words);

/// How alike two pictures are, in [0, 1]: 1 - |a - b| / 2 in the L1 norm (Nister and Stewenius, 2006), which for
/// weights that sum to 1 is the sum of what both have of each word. 0 where either is empty.
double Similarity(const Bag& a, const Bag& b);

}  // namespace yorb

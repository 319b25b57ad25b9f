// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/bag.h"

#include <algorithm>

namespace yorb {

Bag BagOf(std::vector<WordWeight> words) {
  const auto is_nothing = [](const WordWeight& entry) { return !(entry.weight > 0); };
  words.erase(std::remove_if(words.begin(), words.end(), is_nothing), words.end());
  std::stable_sort(words.begin(), words.end(),
                   [](const WordWeight& a, const WordWeight& b) { return a.word < b.word; });
  Bag bag;
  double sum = 0;
  for (const WordWeight& entry : words) {
    sum += entry.weight;
    if (!bag.words.empty() && bag.words.back().word == entry.word) {
      bag.words.back().weight += entry.weight;
    } else {
      bag.words.push_back(entry);
    }
  }
  for (WordWeight& entry : bag.words) entry.weight = static_cast<float>(entry.weight / sum);
  return bag;
}

double Similarity(const Bag& a, const Bag& b) {
  double shared = 0;
  auto in_b = b.words.begin();
  for (const WordWeight& entry : a.words) {
    while (in_b != b.words.end() && in_b->word < entry.word) ++in_b;
    if (in_b == b.words.end()) break;
    if (in_b->word == entry.word) shared += std::min(entry.weight, in_b->weight);
  }
  return shared;
}

}  // namespace yorb

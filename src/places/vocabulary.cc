// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "features/hamming.h"
#include "places/digest.h"

namespace yorb {
namespace {

/// How many steps the deepest node lies below the root; the nodes' children must add up to the nodes.
int DepthOf(const std::vector<uint8_t>& num_children) {
  int depth = 0;
  size_t begin = 0, end = 1;  // the nodes of a level
  while (true) {
    size_t next = end;
    for (size_t node = begin; node < end; ++node) next += num_children[node];
    if (next == end) return depth;
    begin = end, end = next;
    ++depth;
  }
}

/// Breadth first, every node but the root must be the child of one before it.
bool IsOneTree(const std::vector<uint8_t>& num_children) {
  size_t known = 1;
  for (size_t node = 0; node < num_children.size(); ++node) {
    if (node >= known) return false;
    known += num_children[node];
  }
  return known == num_children.size();
}

Status CheckSizes(const VocabularyTree& tree) {
  if (tree.branching < 2 || tree.branching > kMostBranches)
    return BadInput("a tree of " + std::to_string(tree.branching) + " branches; from 2 to 255 are possible");
  if (tree.levels < 1 || tree.levels > kMostTreeLevels)
    return BadInput("a tree of " + std::to_string(tree.levels) + " levels; from 1 to 32 are possible");
  if (tree.num_children.size() < 2 || tree.num_children.size() > kMostTreeNodes)
    return BadInput("a tree without words, or of more than 33 million nodes");
  return Status::Ok();
}

Status CheckTree(const VocabularyTree& tree) {
  if (Status sizes = CheckSizes(tree); !sizes) return sizes;
  const auto& counts = tree.num_children;
  const auto num_words = static_cast<size_t>(std::count(counts.begin(), counts.end(), uint8_t{0}));
  if (!IsOneTree(counts) || tree.centres.size() != counts.size() || tree.word_weights.size() != num_words)
    return BadInput("its nodes, centres and words do not make one tree");
  if (*std::max_element(counts.begin(), counts.end()) > tree.branching || DepthOf(counts) > tree.levels)
    return BadInput("its tree has more branches or levels than it says");
  bool says_something = false;
  for (const float weight : tree.word_weights) {
    if (!std::isfinite(weight) || weight < 0) return BadInput("the weight of a word is negative or no number");
    says_something = says_something || weight > 0;
  }
  if (!says_something) return BadInput("all its words weigh nothing");
  return Status::Ok();
}

uint64_t DigestOf(const VocabularyTree& tree) {
  Digest digest;
  digest.Add(static_cast<uint64_t>(tree.branching));
  digest.Add(static_cast<uint64_t>(tree.levels));
  digest.Add(tree.num_children.data(), tree.num_children.size());
  digest.Add(tree.centres.data(), tree.centres.size() * sizeof(Descriptor));
  digest.Add(tree.word_weights.data(), tree.word_weights.size() * sizeof(float));
  return digest.value();
}

}  // namespace

Result<VocabularyPtr> Vocabulary::Make(VocabularyTree tree) {
  if (Status fine = CheckTree(tree); !fine) return fine.error();
  tree.centres.front() = {};
  return VocabularyPtr(new Vocabulary(std::move(tree)));
}

Vocabulary::Vocabulary(VocabularyTree tree) : tree_(std::move(tree)), digest_(DigestOf(tree_)) {
  first_child_.reserve(tree_.num_children.size());
  uint32_t next_child = 1, next_word = 0;
  for (const uint8_t count : tree_.num_children) {
    first_child_.push_back(count == 0 ? next_word++ : next_child);
    next_child += count;
  }
}

uint32_t Vocabulary::WordOf(const Descriptor& descriptor) const {
  uint32_t node = 0;
  while (tree_.num_children[node] > 0) {
    const uint32_t first = first_child_[node];
    uint32_t nearest = first;
    int least = 257;
    for (uint32_t child = first; child < first + tree_.num_children[node]; ++child) {
      const int distance = HammingDistance(descriptor, tree_.centres[child]);
      if (distance < least) least = distance, nearest = child;
    }
    node = nearest;
  }
  return first_child_[node];
}

Bag Vocabulary::Describe(const std::vector<Descriptor>& descriptors) const {
  std::vector<WordWeight> words;
  words.reserve(descriptors.size());
  for (const Descriptor& descriptor : descriptors) {
    const uint32_t word = WordOf(descriptor);
    words.push_back({word, tree_.word_weights[word]});
  }
  return BagOf(std::move(words));
}

}  // namespace yorb

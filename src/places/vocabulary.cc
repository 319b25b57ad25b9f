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
  if (!IsOneTree(counts) || num_words < 2 || tree.centres.size() != counts.size() ||
      tree.word_weights.size() != num_words)
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

struct Candidate {
  int distance = 0;
  uint32_t node = 0;
};

/// The best few of the candidates that were offered, the nearest first; of equals, the one that was offered first.
class NearestNodes {
 public:
  void Offer(const Candidate& candidate) {
    if (count_ == kMost && candidate.distance >= kept_[kMost - 1].distance) return;
    size_t at = count_ < kMost ? count_++ : kMost - 1;
    for (; at > 0 && candidate.distance < kept_[at - 1].distance; --at) kept_[at] = kept_[at - 1];
    kept_[at] = candidate;
  }

  const Candidate* begin() const { return kept_.data(); }
  const Candidate* end() const { return kept_.data() + count_; }

 private:
  static constexpr size_t kMost = 4;

  std::array<Candidate, kMost> kept_;
  size_t count_ = 0;
};

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

NearestWords Vocabulary::WordsOf(const Descriptor& descriptor) const {
  NearestNodes nearest;
  nearest.Offer({0, 0});
  for (bool goes_down = true; goes_down;) {
    goes_down = false;
    NearestNodes below;
    for (const Candidate& candidate : nearest) {
      const uint32_t count = tree_.num_children[candidate.node], first = first_child_[candidate.node];
      if (count == 0) below.Offer(candidate);
      for (uint32_t child = first; child < first + count; ++child)
        below.Offer({HammingDistance(descriptor, tree_.centres[child]), child});
      goes_down = goes_down || count > 0;
    }
    nearest = below;
  }
  return {first_child_[nearest.begin()[0].node], first_child_[nearest.begin()[1].node]};
}

Bag Vocabulary::Describe(const std::vector<Descriptor>& descriptors) const {
  std::vector<WordWeight> words;
  words.reserve(descriptors.size() * NearestWords().size());
  for (const Descriptor& descriptor : descriptors) {
    for (const uint32_t word : WordsOf(descriptor)) words.push_back({word, tree_.word_weights[word]});
  }
  return BagOf(std::move(words));
}

}  // namespace yorb

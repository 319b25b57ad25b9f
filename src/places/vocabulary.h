// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: places. Which picture shows a place that was seen before, by what is in it alone.
// Takes: descriptors. Gives: Vocabulary, Bag, the places most like a bag. Owns: nothing but its values.
// Runs on: any thread; a Vocabulary is const, a PlaceIndex belongs to who holds it. May not: know poses or maps.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/result.h"
#include "features/keypoint.h"
#include "places/bag.h"

namespace yorb {

/// The bounds of a vocabulary, which keep a bad file from asking for all memory.
constexpr int kMostBranches = 255, kMostTreeLevels = 32;
constexpr size_t kMostTreeNodes = size_t{1} << 25;

/// What a vocabulary is made of: a tree whose nodes stand breadth first, so that children lie next to each other.
struct VocabularyTree {
  int branching = 20;                 ///< at most so many children a node
  int levels = 4;                     ///< the deepest word is so many steps below the root
  std::vector<uint8_t> num_children;  ///< of each node, the root first; 0: the node is a word
  std::vector<Descriptor> centres;    ///< of each node; the root's says nothing
  std::vector<float> word_weights;    ///< how rare each word is (idf), in the order of the nodes that are words
};

/// The words nearest to a descriptor; a vocabulary has two at least.
using NearestWords = std::array<uint32_t, 2>;

/// Tells descriptors apart by a tree of binary centres. From the root down, the few nearest nodes of a level are
/// followed, and a descriptor counts for the two nearest words that they lead to: the one greedy way down, to one word,
/// is much less sure to be the same when the point is seen again. Const once built.
class Vocabulary {
 public:
  /// Bad input, without a file's name, where the parts do not make one tree.
  static Result<std::shared_ptr<const Vocabulary>> Make(VocabularyTree tree);

  /// The words of a picture.
  Bag Describe(const std::vector<Descriptor>& descriptors) const;

  /// The words that a descriptor counts for, each in [0, num_words()), the nearest first.
  NearestWords WordsOf(const Descriptor& descriptor) const;

  size_t num_words() const { return tree_.word_weights.size(); }
  int branching() const { return tree_.branching; }
  int levels() const { return tree_.levels; }
  const VocabularyTree& tree() const { return tree_; }

  /// A number that tells vocabularies apart: equal where all their bits are.
  uint64_t digest() const { return digest_; }

 private:
  explicit Vocabulary(VocabularyTree tree);

  VocabularyTree tree_;
  std::vector<uint32_t> first_child_;  // of each node; of a word: the word's number
  uint64_t digest_ = 0;
};

using VocabularyPtr = std::shared_ptr<const Vocabulary>;

}  // namespace yorb

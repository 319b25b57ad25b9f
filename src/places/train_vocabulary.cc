// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/train_vocabulary.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/parallel.h"
#include "core/random.h"
#include "places/cluster.h"

namespace yorb {
namespace {

/// A node of the level that is being told apart, and its rows.
struct Node {
  size_t first_row = 0, num_rows = 0;
};

Status CheckOptions(const TrainingOptions& options) {
  if (options.branching < 2 || options.branching > kMostBranches)
    return BadInput("branching " + std::to_string(options.branching) + " must be from 2 to 255");
  if (options.levels < 1 || options.levels > kMostTreeLevels)
    return BadInput("levels " + std::to_string(options.levels) + " must be from 1 to 32");
  if (std::pow(options.branching, options.levels) > static_cast<double>(kMostTreeNodes))
    return BadInput("a tree of " + std::to_string(options.branching) + " branches and " +
                    std::to_string(options.levels) + " levels has too many words; 10 and 6 are a million");
  return Status::Ok();
}

std::vector<Descriptor> AllRows(const std::vector<std::vector<Descriptor>>& pictures) {
  std::vector<Descriptor> rows;
  for (const auto& picture : pictures) rows.insert(rows.end(), picture.begin(), picture.end());
  return rows;
}

/// Grows the tree level by level, which gives its nodes breadth first.
class Grower {
 public:
  Grower(std::vector<Descriptor> rows, const TrainingOptions& options, const TrainingHooks& hooks)
      : rows_(std::move(rows)), options_(options), hooks_(hooks) {
    tree_.branching = options.branching;
    tree_.levels = options.levels;
    tree_.centres.push_back({});
    level_ = {{0, rows_.size()}};
  }

  /// The tree without its weights; a tree of the root alone where rows do not differ; nothing where it was stopped.
  std::optional<VocabularyTree> Grow() {
    for (int level = 0; level < options_.levels; ++level) {
      if (!GrowLevel(level)) return std::nullopt;
    }
    tree_.num_children.resize(tree_.centres.size(), 0);
    return std::move(tree_);
  }

 private:
  /// In portions, between which the hooks are called.
  bool GrowLevel(int level) {
    constexpr size_t kPortion = 256;
    std::vector<Node> next;
    for (size_t begin = 0; begin < level_.size(); begin += kPortion) {
      if (hooks_.should_stop && hooks_.should_stop()) return false;
      const size_t end = std::min(level_.size(), begin + kPortion);
      std::vector<Clusters> clusters(end - begin);
      ParallelFor(end - begin, options_.num_threads,
                  [&](size_t i) { clusters[i] = Split(level_[begin + i], level, begin + i); });
      for (size_t i = begin; i < end; ++i) AddChildren(level_[i], clusters[i - begin], next);
      if (hooks_.progress) {
        const size_t done = level_[end - 1].first_row + level_[end - 1].num_rows;
        const auto levels = static_cast<size_t>(options_.levels);
        hooks_.progress(static_cast<size_t>(level) * rows_.size() + done, levels * rows_.size());
      }
    }
    level_ = std::move(next);
    return true;
  }

  Clusters Split(const Node& node, int level, size_t number) {
    if (node.num_rows < static_cast<size_t>(std::max(2, options_.least_rows))) return {};
    Random random(static_cast<uint64_t>(options_.seed), (static_cast<uint64_t>(level) << 40) + number);
    Clusters clusters =
        ClusterRows(rows_.data() + node.first_row, node.num_rows, {options_.branching, options_.most_rounds}, random);
    return clusters.centres.size() > 1 ? clusters : Clusters{};
  }

  void AddChildren(const Node& node, const Clusters& clusters, std::vector<Node>& next) {
    tree_.num_children.push_back(static_cast<uint8_t>(clusters.centres.size()));
    tree_.centres.insert(tree_.centres.end(), clusters.centres.begin(), clusters.centres.end());
    size_t first_row = node.first_row;
    for (const size_t size : clusters.sizes) {
      next.push_back({first_row, size});
      first_row += size;
    }
  }

  std::vector<Descriptor> rows_;
  const TrainingOptions& options_;
  const TrainingHooks& hooks_;
  VocabularyTree tree_;
  std::vector<Node> level_;
};

/// How rare each word is: log(1 + pictures / pictures that have it), which is never 0, so that few pictures do, too.
std::vector<float> RarenessOf(const Vocabulary& vocabulary, const std::vector<std::vector<Descriptor>>& pictures,
                              int num_threads) {
  constexpr size_t kPortion = 256;
  std::vector<size_t> num_with(vocabulary.num_words(), 0);
  for (size_t begin = 0; begin < pictures.size(); begin += kPortion) {
    std::vector<Bag> bags(std::min(kPortion, pictures.size() - begin));
    ParallelFor(bags.size(), num_threads, [&](size_t i) { bags[i] = vocabulary.Describe(pictures[begin + i]); });
    for (const Bag& bag : bags) {
      for (const WordWeight& entry : bag.words) ++num_with[entry.word];
    }
  }
  std::vector<float> rareness;
  for (const size_t num : num_with) {
    const double share = static_cast<double>(pictures.size()) / static_cast<double>(std::max<size_t>(1, num));
    rareness.push_back(static_cast<float>(std::log1p(share)));
  }
  return rareness;
}

}  // namespace

Result<VocabularyPtr> TrainVocabulary(const std::vector<std::vector<Descriptor>>& pictures,
                                      const TrainingOptions& options, const TrainingHooks& hooks) {
  if (Status fine = CheckOptions(options); !fine) return fine.error();
  std::vector<Descriptor> rows = AllRows(pictures);
  if (rows.empty()) return BadInput("the pictures show no points to learn from; take sharper ones");
  std::optional<VocabularyTree> tree = Grower(std::move(rows), options, hooks).Grow();
  if (!tree) return Failure("the training was stopped");
  if (tree->centres.size() < 3) return BadInput("the pictures show too little to learn from; take more of them");
  const auto words = std::count(tree->num_children.begin(), tree->num_children.end(), uint8_t{0});
  tree->word_weights.assign(static_cast<size_t>(words), 1.f);
  const auto unweighted = Vocabulary::Make(*tree);
  if (!unweighted) return unweighted.error();
  tree->word_weights = RarenessOf(**unweighted, pictures, options.num_threads);
  return Vocabulary::Make(*std::move(tree));
}

}  // namespace yorb

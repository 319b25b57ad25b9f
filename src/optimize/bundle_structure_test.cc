// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/bundle_structure.h"

#include <gtest/gtest.h>

#include <set>

#include "optimize/test_problems.h"

namespace yorb {
namespace {

WorldProblem World() {
  WorldOptions options;
  options.poses = 12, options.points = 60, options.fixed = 2;
  options.range = 6;
  return MakeWorld(options);
}

TEST(BundleStructure, TiesExactlyThePosesThatShareAPoint) {
  const BundleProblem problem = World().problem;
  std::vector<bool> is_chosen(problem.seen.size());
  for (size_t k = 0; k < is_chosen.size(); ++k) is_chosen[k] = k % 3 != 0;
  const BundleStructure structure = MakeBundleStructure(problem, is_chosen);
  // The slow twin: every pair of chosen observations.
  std::set<std::pair<uint32_t, uint32_t>> expected;
  for (size_t a = 0; a < problem.seen.size(); ++a) {
    for (size_t b = 0; b < problem.seen.size(); ++b) {
      const BundleProblem::Seen &one = problem.seen[a], &other = problem.seen[b];
      if (!is_chosen[a] || !is_chosen[b] || one.point != other.point || one.pose > other.pose) continue;
      if (!problem.is_fixed[one.pose] && !problem.is_fixed[other.pose]) expected.emplace(one.pose, other.pose);
    }
  }
  std::set<std::pair<uint32_t, uint32_t>> found;
  const std::vector<std::pair<uint32_t, uint32_t>>& blocks = structure.pattern.blocks;
  for (size_t k = 0; k < blocks.size(); ++k) {
    found.emplace(structure.free_poses[blocks[k].first], structure.free_poses[blocks[k].second]);
    if (k < structure.pattern.size) {
      EXPECT_EQ(blocks[k].first, blocks[k].second);
    } else if (k > structure.pattern.size) {
      EXPECT_LT(blocks[k - 1], blocks[k]);
    }
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.size(), blocks.size());
}

TEST(BundleStructure, KnowsTheBlockOfEveryPair) {
  const BundleProblem problem = World().problem;
  const BundleStructure structure = MakeBundleStructure(problem, std::vector<bool>(problem.seen.size(), true));
  size_t num_pairs = 0;
  for (const BundleStructure::Point& point : structure.points) {
    EXPECT_EQ(point.pairs_begin, num_pairs);
    for (uint32_t a = point.links_begin; a < point.links_end; ++a) {
      for (uint32_t b = a; b < point.links_end; ++b) {
        const auto expected = std::make_pair(structure.links[a], structure.links[b]);
        EXPECT_EQ(structure.pattern.blocks[structure.pair_slots[num_pairs++]], expected);
      }
    }
  }
  EXPECT_EQ(num_pairs, structure.pair_slots.size());
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/bundle_structure.h"

#include <algorithm>

namespace yorb {
namespace {

/// The chosen rows of `problem.seen`, by point, then pose, then row.
std::vector<uint32_t> SortedRows(const BundleProblem& problem, const std::vector<bool>& is_chosen) {
  std::vector<uint32_t> begin(problem.points.size() + 1, 0);
  for (size_t k = 0; k < problem.seen.size(); ++k) {
    if (is_chosen[k]) ++begin[problem.seen[k].point + 1];
  }
  for (size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
  std::vector<uint32_t> rows(begin.back());
  std::vector<uint32_t> next(begin.begin(), begin.end() - 1);
  for (size_t k = 0; k < problem.seen.size(); ++k) {
    if (is_chosen[k]) rows[next[problem.seen[k].point]++] = static_cast<uint32_t>(k);
  }
  for (size_t p = 0; p + 1 < begin.size(); ++p) {
    std::sort(rows.begin() + begin[p], rows.begin() + begin[p + 1], [&](uint32_t a, uint32_t b) {
      const uint32_t pose_a = problem.seen[a].pose, pose_b = problem.seen[b].pose;
      return pose_a != pose_b ? pose_a < pose_b : a < b;
    });
  }
  return rows;
}

/// A problem's poses to rows of `free_poses`; none for the others.
std::vector<uint32_t> NumberFreePoses(const BundleProblem& problem, const std::vector<uint32_t>& rows,
                                      std::vector<uint32_t>& free_poses) {
  std::vector<bool> is_free(problem.poses.size(), false);
  for (const uint32_t row : rows) {
    const uint32_t pose = problem.seen[row].pose;
    is_free[pose] = !problem.is_fixed[pose];
  }
  std::vector<uint32_t> free_of_pose(problem.poses.size(), BundleStructure::kNone);
  for (uint32_t pose = 0; pose < is_free.size(); ++pose) {
    if (!is_free[pose]) continue;
    free_of_pose[pose] = static_cast<uint32_t>(free_poses.size());
    free_poses.push_back(pose);
  }
  return free_of_pose;
}

/// Fills entries, points and links.
void AddEntries(const BundleProblem& problem, const std::vector<uint32_t>& rows,
                const std::vector<uint32_t>& free_of_pose, BundleStructure& structure) {
  structure.entries.reserve(rows.size());
  structure.links.reserve(rows.size());
  for (const uint32_t row : rows) {
    const BundleProblem::Seen& seen = problem.seen[row];
    if (structure.points.empty() || structure.points.back().row != seen.point) {
      BundleStructure::Point point;
      point.row = seen.point;
      point.entries_begin = static_cast<uint32_t>(structure.entries.size());
      point.links_begin = point.links_end = static_cast<uint32_t>(structure.links.size());
      structure.points.push_back(point);
    }
    BundleStructure::Point& point = structure.points.back();
    BundleStructure::Entry entry{seen.pose, free_of_pose[seen.pose], BundleStructure::kNone, seen.observation};
    if (entry.free != BundleStructure::kNone) {
      const bool is_new = point.links_end == point.links_begin || structure.links.back() != entry.free;
      if (is_new) structure.links.push_back(entry.free);
      point.links_end = static_cast<uint32_t>(structure.links.size());
      entry.link = point.links_end - 1;
    }
    structure.entries.push_back(entry);
    point.entries_end = static_cast<uint32_t>(structure.entries.size());
  }
}

/// Calls `visit(free pose a, free pose b)` for every pair of every point, in the order of `pair_slots`.
template <typename Visitor>
void ForEachPair(BundleStructure& structure, Visitor&& visit) {
  for (BundleStructure::Point& point : structure.points) {
    for (uint32_t a = point.links_begin; a < point.links_end; ++a) {
      for (uint32_t b = a; b < point.links_end; ++b) visit(point, structure.links[a], structure.links[b]);
    }
  }
}

/// Fills the pattern and the pairs.
void AddPairs(BundleStructure& structure) {
  const auto size = static_cast<uint32_t>(structure.free_poses.size());
  std::vector<uint32_t> slot_of(size_t{size} * size, BundleStructure::kNone);
  for (uint32_t k = 0; k < size; ++k) slot_of[size_t{k} * size + k] = k;
  size_t num_pairs = 0;
  ForEachPair(structure, [&](BundleStructure::Point&, uint32_t a, uint32_t b) {
    if (a != b) slot_of[size_t{a} * size + b] = 0;
    ++num_pairs;
  });
  structure.pattern.size = size;
  for (uint32_t k = 0; k < size; ++k) structure.pattern.blocks.emplace_back(k, k);
  for (uint32_t a = 0; a < size; ++a) {
    for (uint32_t b = a + 1; b < size; ++b) {
      uint32_t& slot = slot_of[size_t{a} * size + b];
      if (slot == BundleStructure::kNone) continue;
      slot = static_cast<uint32_t>(structure.pattern.blocks.size());
      structure.pattern.blocks.emplace_back(a, b);
    }
  }
  structure.pair_slots.reserve(num_pairs);
  const BundleStructure::Point* last = nullptr;
  ForEachPair(structure, [&](BundleStructure::Point& point, uint32_t a, uint32_t b) {
    if (last != &point) point.pairs_begin = structure.pair_slots.size();
    last = &point;
    structure.pair_slots.push_back(slot_of[size_t{a} * size + b]);
  });
}

}  // namespace

BundleStructure MakeBundleStructure(const BundleProblem& problem, const std::vector<bool>& is_chosen) {
  BundleStructure structure;
  const std::vector<uint32_t> rows = SortedRows(problem, is_chosen);
  const std::vector<uint32_t> free_of_pose = NumberFreePoses(problem, rows, structure.free_poses);
  AddEntries(problem, rows, free_of_pose, structure);
  AddPairs(structure);
  return structure;
}

}  // namespace yorb

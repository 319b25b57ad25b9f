// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/bundle_structure.h"

#include <algorithm>
#include <utility>

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

/// A point that a pose sees: rows of `points` and `links`.
struct Sight {
  uint32_t point = 0, link = 0;
};

/// What each free pose sees, pose after pose; those of pose a begin at `begin[a]`.
struct Sights {
  std::vector<size_t> begin;
  std::vector<Sight> sights;
};

Sights SortByPose(const BundleStructure& structure) {
  Sights sorted;
  sorted.begin.resize(structure.free_poses.size() + 1, 0);
  for (const uint32_t pose : structure.links) ++sorted.begin[pose + 1];
  for (size_t k = 1; k < sorted.begin.size(); ++k) sorted.begin[k] += sorted.begin[k - 1];
  sorted.sights.resize(structure.links.size());
  std::vector<size_t> next(sorted.begin.begin(), sorted.begin.end() - 1);
  for (uint32_t k = 0; k < structure.points.size(); ++k) {
    const BundleStructure::Point& point = structure.points[k];
    for (uint32_t link = point.links_begin; link < point.links_end; ++link) {
      sorted.sights[next[structure.links[link]]++] = {k, link};
    }
  }
  return sorted;
}

/// Makes room for the pairs of all points.
void CountPairs(BundleStructure& structure) {
  size_t num_pairs = 0;
  for (BundleStructure::Point& point : structure.points) {
    const size_t count = point.links_end - point.links_begin;
    point.pairs_begin = num_pairs;
    num_pairs += count * (count + 1) / 2;
  }
  structure.pair_slots.resize(num_pairs);
}

/// Takes in the ties of poses that are free. Those that are not finite do not count.
void AddTies(const BundleProblem& problem, const std::vector<uint32_t>& free_of_pose, BundleStructure& structure) {
  for (const BundleProblem::Tie& tie : problem.ties) {
    const uint32_t from = free_of_pose[tie.from], to = free_of_pose[tie.to];
    if (from == BundleStructure::kNone && to == BundleStructure::kNone) continue;
    const bool is_whole = problem.poses[tie.from].IsFinite() && problem.poses[tie.to].IsFinite() &&
                          tie.to_from_from.IsFinite() && tie.information.allFinite();
    if (!is_whole) continue;
    structure.ties.push_back({tie, from, to});
  }
}

/// Takes in the lines that free poses see. Those that are not finite do not count.
void AddLines(const BundleProblem& problem, const std::vector<uint32_t>& free_of_pose, BundleStructure& structure) {
  for (const BundleProblem::Line& line : problem.lines) {
    const uint32_t free = free_of_pose[line.pose];
    const bool is_whole = line.normal_in_cam.allFinite() && line.direction_in_world.allFinite() && line.sigma > 0;
    if (free != BundleStructure::kNone && is_whole) structure.lines.push_back({line, free});
  }
}

/// The free poses that ties join to each free pose, of those after it.
std::vector<std::vector<uint32_t>> TiedTo(const BundleStructure& structure) {
  std::vector<std::vector<uint32_t>> tied(structure.free_poses.size());
  for (const BundleStructure::Tie& tie : structure.ties) {
    if (tie.free_from == BundleStructure::kNone || tie.free_to == BundleStructure::kNone) continue;
    tied[std::min(tie.free_from, tie.free_to)].push_back(std::max(tie.free_from, tie.free_to));
  }
  return tied;
}

/// Finds the blocks of the ties in the pattern.
void PlaceTies(BundleStructure& structure) {
  const auto& blocks = structure.pattern.blocks;
  for (BundleStructure::Tie& tie : structure.ties) {
    if (tie.free_from == BundleStructure::kNone || tie.free_to == BundleStructure::kNone) continue;
    const auto wanted = std::minmax(tie.free_from, tie.free_to);
    const auto found = std::lower_bound(blocks.begin() + structure.pattern.size, blocks.end(),
                                        std::pair<uint32_t, uint32_t>(wanted.first, wanted.second));
    tie.slot = static_cast<uint32_t>(found - blocks.begin());
  }
}

/// Fills the pattern and the pairs, row by row of the reduced system: nothing here grows with the square of the poses.
void AddPairs(BundleStructure& structure) {
  const auto size = static_cast<uint32_t>(structure.free_poses.size());
  const Sights sorted = SortByPose(structure);
  CountPairs(structure);
  structure.pattern.size = size;
  for (uint32_t k = 0; k < size; ++k) structure.pattern.blocks.emplace_back(k, k);
  std::vector<uint32_t> seen_by(size, BundleStructure::kNone), slot_of(size), columns;
  const std::vector<std::vector<uint32_t>> tied = TiedTo(structure);
  for (uint32_t a = 0; a < size; ++a) {
    columns.clear();
    for (const uint32_t b : tied[a]) {
      if (std::exchange(seen_by[b], a) != a) columns.push_back(b);
    }
    for (size_t k = sorted.begin[a]; k < sorted.begin[a + 1]; ++k) {
      const auto [point, link] = sorted.sights[k];
      for (uint32_t other = link + 1; other < structure.points[point].links_end; ++other) {
        const uint32_t b = structure.links[other];
        if (std::exchange(seen_by[b], a) != a) columns.push_back(b);
      }
    }
    std::sort(columns.begin(), columns.end());
    slot_of[a] = a;
    for (const uint32_t b : columns) {
      slot_of[b] = static_cast<uint32_t>(structure.pattern.blocks.size());
      structure.pattern.blocks.emplace_back(a, b);
    }
    for (size_t k = sorted.begin[a]; k < sorted.begin[a + 1]; ++k) {
      const auto [row, link] = sorted.sights[k];
      const BundleStructure::Point& point = structure.points[row];
      const size_t first = link - point.links_begin, count = point.links_end - point.links_begin;
      uint32_t* slot = structure.pair_slots.data() + point.pairs_begin + first * (2 * count - first + 1) / 2;
      for (uint32_t other = link; other < point.links_end; ++other) *slot++ = slot_of[structure.links[other]];
    }
  }
}

}  // namespace

BundleStructure MakeBundleStructure(const BundleProblem& problem, const std::vector<bool>& is_chosen) {
  BundleStructure structure;
  const std::vector<uint32_t> rows = SortedRows(problem, is_chosen);
  const std::vector<uint32_t> free_of_pose = NumberFreePoses(problem, rows, structure.free_poses);
  AddEntries(problem, rows, free_of_pose, structure);
  AddTies(problem, free_of_pose, structure);
  AddLines(problem, free_of_pose, structure);
  AddPairs(structure);
  PlaceTies(structure);
  return structure;
}

}  // namespace yorb

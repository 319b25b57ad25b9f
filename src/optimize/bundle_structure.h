// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "optimize/bundle.h"
#include "optimize/reduced_system.h"

namespace yorb {

/// Who sees what in the order in which points are eliminated: all that stays the same from iteration to iteration.
/// A "link" is a point and a free pose that sees it; a "pair" is two links of one point, whose poses the elimination of
/// the point ties together.
struct BundleStructure {
  static constexpr uint32_t kNone = 0xffffffffu;

  struct Entry {
    uint32_t pose = 0;      ///< row of the problem's poses
    uint32_t free = kNone;  ///< row of `free_poses`, or none: the pose is fixed
    uint32_t link = kNone;  ///< row of `links`, or none: the pose is fixed
    Observation observation;
  };
  struct Point {
    uint32_t row = 0;  ///< of the problem's points
    uint32_t entries_begin = 0, entries_end = 0;
    uint32_t links_begin = 0, links_end = 0;
    size_t pairs_begin = 0;
  };

  struct Tie {
    BundleProblem::Tie tie;
    uint32_t free_from = kNone, free_to = kNone;  ///< rows of `free_poses`, or none: the pose is fixed
    uint32_t slot = kNone;                        ///< the block of both, if both are free
  };

  struct Line {
    BundleProblem::Line line;
    uint32_t free = kNone;
  };

  std::vector<Tie> ties;             ///< those with a free pose
  std::vector<Line> lines;           ///< those of a free pose
  std::vector<Entry> entries;        ///< by point, then by pose
  std::vector<Point> points;         ///< those that are seen
  std::vector<uint32_t> links;       ///< the link's row of `free_poses`; rising within a point
  std::vector<uint32_t> free_poses;  ///< rows of the problem's poses: not fixed, and something is seen from them
  BlockPattern pattern;              ///< of the reduced system
  std::vector<uint32_t> pair_slots;  ///< for each point, for each link a and each link b >= a: the block of (a, b)
};

/// Orders the entries of `problem.seen` that are chosen. The result does not depend on their order, but for the order
/// of several observations of one point from one pose.
BundleStructure MakeBundleStructure(const BundleProblem& problem, const std::vector<bool>& is_chosen);

}  // namespace yorb

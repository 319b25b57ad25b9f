// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "features/fast.h"

namespace yorb {

/// The part of a level that may hold corners: left <= x < right, top <= y < bottom.
struct CornerArea {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Spreads corners over a picture by splitting it into quarters, and keeps the best. Both ways give at most `wanted`
/// corners, in the order in which they came; equal responses are told apart by lot (always the same). Results live
/// until the next call.
class Quadtree {
 public:
  /// The original: splits until there are `wanted` nodes (the fullest first when near the end) or no node holds two
  /// corners, and keeps the best corner of each.
  const std::vector<Corner>& KeepBestOfEach(const std::vector<Corner>& corners, const CornerArea& area, int wanted);

  /// The improved one: splits in rounds until there are 0.7 * `wanted` nodes, keeps the corner of every node that holds
  /// a single one, and fills up with the best n of all others, whichever node they are in: equation (4),
  /// n = wanted - singles.
  const std::vector<Corner>& KeepSinglesAndBest(const std::vector<Corner>& corners, const CornerArea& area, int wanted);

 private:
  /// A rectangle and its corners: order_[begin] to order_[end - 1].
  struct Node {
    CornerArea area;
    uint32_t begin = 0, end = 0;

    uint32_t size() const { return end - begin; }
    bool CanSplit() const { return size() > 1 && (area.right - area.left > 1 || area.bottom - area.top > 1); }
  };

  void Start(const std::vector<Corner>& corners, const CornerArea& area);
  void SplitAll(const std::vector<Corner>& corners);
  void SplitFullest(const std::vector<Corner>& corners, size_t wanted);
  void Split(const std::vector<Corner>& corners, const Node& node);
  size_t CountSplittable() const;
  uint32_t BestOf(const std::vector<Corner>& corners, const Node& node) const;
  void KeepStrongest(const std::vector<Corner>& corners, std::vector<uint32_t>& indices, size_t count) const;
  const std::vector<Corner>& Take(const std::vector<Corner>& corners, size_t wanted);

  std::vector<Node> nodes_, next_;
  std::vector<uint32_t> order_, moved_;  ///< indices of corners
  std::vector<uint32_t> fullest_;        ///< indices of nodes
  std::vector<uint32_t> kept_, crowd_;   ///< indices of corners
  std::vector<Corner> chosen_;
};

}  // namespace yorb

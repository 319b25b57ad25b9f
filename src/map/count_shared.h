// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "map/map.h"

namespace yorb {

/// Counts the landmarks that keyframes share, from the landmarks' views alone.
class SharedCounter {
 public:
  /// With whom this keyframe shares how many, by ascending id; all its landmarks must be there.
  std::vector<Neighbour> Count(const Map& map, const Keyframe& keyframe) {
    std::vector<Neighbour> shared;
    for (const LandmarkId id : keyframe.landmarks) {
      if (!id.IsValid()) continue;
      for (const LandmarkView& view : map.Find(id)->views) {
        const size_t other = view.keyframe.value();
        if (other >= counts_.size()) counts_.resize(other + 1, 0);
        if (counts_[other]++ == 0) shared.push_back({view.keyframe, 0});
      }
    }
    for (Neighbour& neighbour : shared) neighbour.weight = std::exchange(counts_[neighbour.id.value()], 0);
    shared.erase(std::remove_if(shared.begin(), shared.end(), [&](const Neighbour& n) { return n.id == keyframe.id; }),
                 shared.end());
    std::sort(shared.begin(), shared.end(), [](const Neighbour& a, const Neighbour& b) { return a.id < b.id; });
    return shared;
  }

 private:
  std::vector<int> counts_;  ///< all zero between two calls
};

}  // namespace yorb

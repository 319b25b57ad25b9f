// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/fuse.h"

#include <algorithm>

#include "matching/duplicates.h"

namespace yorb {
namespace {

/// The neighbours, the parent, which need not have a landmark in common yet, and half as many neighbours of each.
std::vector<KeyframeId> Targets(const Map& map, KeyframeId center, size_t num_neighbours) {
  std::vector<KeyframeId> targets = map.Find(center)->Strongest(num_neighbours, 1);
  const KeyframeId parent = map.Find(center)->parent;
  if (parent.IsValid() && map.Find(center)->NumShared(parent) == 0) targets.push_back(parent);
  const size_t num_direct = targets.size();
  for (size_t i = 0; i < num_direct; ++i) {
    for (const KeyframeId id : map.Find(targets[i])->Strongest(num_neighbours / 2, 1)) {
      const bool is_known = id == center || std::find(targets.begin(), targets.end(), id) != targets.end();
      if (!is_known && targets.size() < 2 * num_neighbours) targets.push_back(id);
    }
  }
  return targets;
}

void Apply(Map& map, const std::vector<Sighting>& sightings, KeyframeId keyframe) {
  for (const auto& [id, index] : sightings) {
    if (!map.Find(id)) continue;
    const LandmarkId there = map.Find(keyframe)->landmarks[index];
    if (!there.IsValid()) {
      if (map.Observe(id, keyframe, index)) map.Refresh(id);
    } else if (there != id) {
      const bool is_better_known = map.Find(id)->views.size() > map.Find(there)->views.size();
      map.Merge(is_better_known ? there : id, is_better_known ? id : there);
    }
  }
}

}  // namespace

void FuseWithNeighbours(Map& map, KeyframeId keyframe, size_t num_neighbours) {
  const std::vector<KeyframeId> targets = Targets(map, keyframe, num_neighbours);
  for (const KeyframeId target : targets) {
    Apply(map, FindSightings(map, map.SeenBy({keyframe}), *map.Find(target)), target);
  }
  Apply(map, FindSightings(map, map.SeenBy(targets), *map.Find(keyframe)), keyframe);
}

void FuseAcross(Map& map, const std::vector<KeyframeId>& ones, const std::vector<KeyframeId>& others) {
  const auto look = [&map](const std::vector<KeyframeId>& from, const std::vector<KeyframeId>& by) {
    for (const KeyframeId id : by) Apply(map, FindSightings(map, map.SeenBy(from), *map.Find(id)), id);
  };
  look(others, ones);
  look(ones, others);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/cull.h"

#include <algorithm>

namespace yorb {
namespace {

bool IsRedundant(const Map& map, const Keyframe& keyframe, double redundant_share) {
  constexpr int kOthers = 3;
  const Frame& frame = *keyframe.frame;
  int num_points = 0, num_redundant = 0;
  for (size_t i = 0; i < frame.size(); ++i) {
    const LandmarkId id = keyframe.landmarks[i];
    if (!id.IsValid() || !frame.HasDepth(i) || frame.depth[i] > frame.rig->CloseDepth()) continue;
    ++num_points;
    int num_others = 0;
    for (const LandmarkView& view : map.Find(id)->views) {
      if (view.keyframe == keyframe.id) continue;
      const Keypoint& other = map.Find(view.keyframe)->frame->keypoints[view.index];
      num_others += other.octave <= frame.keypoints[i].octave + 1;
    }
    num_redundant += num_others >= kOthers;
  }
  return num_redundant > redundant_share * num_points;
}

}  // namespace

int NumRays(const Map& map, const Landmark& landmark) {
  int count = 0;
  for (const LandmarkView& view : landmark.views) count += map.Find(view.keyframe)->frame->HasDepth(view.index) ? 2 : 1;
  return count;
}

std::vector<LandmarkId> CullRecentLandmarks(Map& map, const std::vector<LandmarkId>& recent) {
  constexpr double kMinFoundShare = 0.25;
  constexpr uint32_t kYoung = 2, kGrownUp = 3;  // keyframes since birth
  constexpr int kTooFewRays = 3;
  std::vector<LandmarkId> still_recent;
  const KeyframeId root = map.Find(map.newest_keyframe())->root;
  for (const LandmarkId id : recent) {
    const Landmark* landmark = map.Find(id);
    // What was left behind in another sub-map is not judged by what is seen here.
    if (!landmark || map.Find(landmark->reference)->root != root) continue;
    const uint32_t age = map.newest_keyframe().value() - landmark->first_keyframe.value();
    const bool is_hardly_found = landmark->num_found < kMinFoundShare * landmark->num_visible;
    if (is_hardly_found || (age >= kYoung && NumRays(map, *landmark) <= kTooFewRays)) {
      map.Remove(id);
    } else if (age < kGrownUp) {
      still_recent.push_back(id);
    }
  }
  return still_recent;
}

size_t RemoveGone(Map& map, const std::vector<LandmarkCount>& counts) {
  constexpr int kOftenGone = 3;
  size_t num_removed = 0;
  for (const LandmarkCount& count : counts) {
    if (count.gone < kOftenGone || count.gone <= count.found) continue;
    const LandmarkId id = map.Resolve(count.id);
    if (!map.Find(id)) continue;
    map.Remove(id);
    ++num_removed;
  }
  return num_removed;
}

void CullKeyframes(Map& map, KeyframeId center, double redundant_share) {
  const std::vector<Neighbour> neighbours = map.Find(center)->neighbours;
  for (const Neighbour& neighbour : neighbours) {
    const Keyframe& keyframe = *map.Find(neighbour.id);
    const bool may_go = keyframe.parent.IsValid() && keyframe.loops.empty();
    if (may_go && IsRedundant(map, keyframe, redundant_share)) map.Remove(neighbour.id);
  }
}

}  // namespace yorb

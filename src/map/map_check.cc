// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "map/count_shared.h"
#include "map/map.h"

namespace yorb {
namespace {

std::string CheckLandmark(const Map& map, const Landmark& landmark) {
  if (landmark.views.empty()) return NameOf(landmark.id) + " has no view";
  if (!landmark.position.allFinite()) return NameOf(landmark.id) + " is nowhere";
  if (!landmark.ViewOf(landmark.reference)) return NameOf(landmark.id) + " is not seen by its reference";
  for (size_t i = 0; i < landmark.views.size(); ++i) {
    const LandmarkView& view = landmark.views[i];
    if (i > 0 && !(landmark.views[i - 1].keyframe < view.keyframe)) return NameOf(landmark.id) + " has unsorted views";
    const Keyframe* keyframe = map.Find(view.keyframe);
    if (!keyframe) return NameOf(landmark.id) + " is seen by a keyframe that is not there";
    if (keyframe->landmarks[view.index] != landmark.id)
      return NameOf(view.keyframe) + " does not know " + NameOf(landmark.id);
  }
  return {};
}

std::string CheckKeyframe(const Map& map, const Keyframe& keyframe, SharedCounter& counter) {
  if (keyframe.landmarks.size() != keyframe.frame->size()) return NameOf(keyframe.id) + " has rows for other keypoints";
  if (!keyframe.cam_from_world.IsFinite()) return NameOf(keyframe.id) + " is nowhere";
  for (const LandmarkId id : keyframe.landmarks) {
    if (!id.IsValid()) continue;
    const Landmark* landmark = map.Find(id);
    if (!landmark || !landmark->ViewOf(keyframe.id)) return NameOf(keyframe.id) + " sees " + NameOf(id) + " alone";
  }
  const std::vector<Neighbour> shared = counter.Count(map, keyframe);
  if (shared.size() != keyframe.neighbours.size()) return NameOf(keyframe.id) + " has wrong neighbours";
  for (size_t i = 0; i < shared.size(); ++i) {
    if (shared[i].id != keyframe.neighbours[i].id) return NameOf(keyframe.id) + " has wrong neighbours";
    if (shared[i].weight != keyframe.neighbours[i].weight) return NameOf(keyframe.id) + " has a wrong weight";
  }
  return {};
}

std::string CheckTree(const Map& map, const Keyframe& keyframe) {
  const Keyframe* parent = keyframe.parent.IsValid() ? map.Find(keyframe.parent) : &keyframe;
  if (!parent) return NameOf(keyframe.id) + " hangs below a keyframe that is not there";
  if (keyframe.root != (keyframe.parent.IsValid() ? parent->root : keyframe.id)) {
    return NameOf(keyframe.id) + " names another root than its tree's";
  }
  for (const KeyframeId child : keyframe.children) {
    const Keyframe* found = map.Find(child);
    if (!found || found->parent != keyframe.id) return NameOf(keyframe.id) + " has a child with another parent";
  }
  for (const Neighbour& neighbour : keyframe.neighbours) {
    if (map.Find(neighbour.id)->root != keyframe.root)
      return NameOf(keyframe.id) + " has a neighbour in another sub-map";
  }
  for (const KeyframeId loop : keyframe.loops) {
    const Keyframe* other = map.Find(loop);
    const bool is_known = other && std::count(other->loops.begin(), other->loops.end(), keyframe.id) == 1;
    if (!is_known) return NameOf(keyframe.id) + " has a loop to a keyframe that does not know of it";
  }
  return {};
}

/// Whether a walk up the tree ends, for each keyframe; parents are there.
std::string CheckRings(const Map& map) {
  std::string broken;
  std::vector<bool> leads_up(map.next_keyframe().value(), false);
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    std::vector<KeyframeId> walk;
    for (KeyframeId id = keyframe.id; broken.empty() && id.IsValid() && !leads_up[id.value()];) {
      if (walk.size() == map.num_keyframes()) broken = NameOf(keyframe.id) + " hangs in a ring";
      walk.push_back(id);
      id = map.Find(id)->parent;
    }
    for (const KeyframeId id : walk) leads_up[id.value()] = true;
  });
  return broken;
}

}  // namespace

std::string Map::Check() const {
  std::string broken;
  SharedCounter counter;
  VisitLandmarks([&](const Landmark& landmark) {
    if (broken.empty()) broken = CheckLandmark(*this, landmark);
  });
  VisitKeyframes([&](const Keyframe& keyframe) {
    if (broken.empty()) broken = CheckKeyframe(*this, keyframe, counter);
    if (broken.empty()) broken = CheckTree(*this, keyframe);
  });
  if (broken.empty()) broken = CheckRings(*this);
  for (const auto& [from, into] : merged_into_) {
    if (broken.empty() && Find(from)) broken = NameOf(from) + " was merged and is still there";
  }
  return broken;
}

}  // namespace yorb

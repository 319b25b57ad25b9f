// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "map/count_shared.h"
#include "map/map.h"

namespace yorb {
namespace {

std::string Name(KeyframeId id) { return "keyframe " + std::to_string(id.value()); }
std::string Name(LandmarkId id) { return "landmark " + std::to_string(id.value()); }

std::string CheckLandmark(const Map& map, const Landmark& landmark) {
  if (landmark.views.empty()) return Name(landmark.id) + " has no view";
  if (!landmark.position.allFinite()) return Name(landmark.id) + " is nowhere";
  if (!landmark.ViewOf(landmark.reference)) return Name(landmark.id) + " is not seen by its reference";
  for (size_t i = 0; i < landmark.views.size(); ++i) {
    const LandmarkView& view = landmark.views[i];
    if (i > 0 && !(landmark.views[i - 1].keyframe < view.keyframe)) return Name(landmark.id) + " has unsorted views";
    const Keyframe* keyframe = map.Find(view.keyframe);
    if (!keyframe) return Name(landmark.id) + " is seen by a keyframe that is not there";
    if (keyframe->landmarks[view.index] != landmark.id)
      return Name(view.keyframe) + " does not know " + Name(landmark.id);
  }
  return {};
}

std::string CheckKeyframe(const Map& map, const Keyframe& keyframe, SharedCounter& counter) {
  if (keyframe.landmarks.size() != keyframe.frame->size()) return Name(keyframe.id) + " has rows for other keypoints";
  if (!keyframe.cam_from_world.IsFinite()) return Name(keyframe.id) + " is nowhere";
  for (const LandmarkId id : keyframe.landmarks) {
    if (!id.IsValid()) continue;
    const Landmark* landmark = map.Find(id);
    if (!landmark || !landmark->ViewOf(keyframe.id)) return Name(keyframe.id) + " sees " + Name(id) + " alone";
  }
  const std::vector<Neighbour> shared = counter.Count(map, keyframe);
  if (shared.size() != keyframe.neighbours.size()) return Name(keyframe.id) + " has wrong neighbours";
  for (size_t i = 0; i < shared.size(); ++i) {
    if (shared[i].id != keyframe.neighbours[i].id) return Name(keyframe.id) + " has wrong neighbours";
    if (shared[i].weight != keyframe.neighbours[i].weight) return Name(keyframe.id) + " has a wrong weight";
  }
  return {};
}

std::string CheckTree(const Map& map, const Keyframe& keyframe) {
  size_t steps = 0;
  const Keyframe* above = &keyframe;
  while (above && above->parent.IsValid() && steps++ <= map.num_keyframes()) above = map.Find(above->parent);
  if (!above) return Name(keyframe.id) + " hangs below a keyframe that is not there";
  if (above->parent.IsValid()) return Name(keyframe.id) + " hangs in a ring";
  if (above->id != keyframe.root) return Name(keyframe.id) + " names another root than its tree's";
  for (const KeyframeId child : keyframe.children) {
    const Keyframe* found = map.Find(child);
    if (!found || found->parent != keyframe.id) return Name(keyframe.id) + " has a child with another parent";
  }
  for (const Neighbour& neighbour : keyframe.neighbours) {
    if (map.Find(neighbour.id)->root != keyframe.root) return Name(keyframe.id) + " has a neighbour in another sub-map";
  }
  for (const KeyframeId loop : keyframe.loops) {
    const Keyframe* other = map.Find(loop);
    const bool is_known = other && std::count(other->loops.begin(), other->loops.end(), keyframe.id) == 1;
    if (!is_known) return Name(keyframe.id) + " has a loop to a keyframe that does not know of it";
  }
  return {};
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
  for (const auto& [from, into] : merged_into_) {
    if (broken.empty() && Find(from)) broken = Name(from) + " was merged and is still there";
  }
  return broken;
}

}  // namespace yorb

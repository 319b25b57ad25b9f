// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/map_parts.h"

#include <algorithm>
#include <string>
#include <utility>

#include "map/count_shared.h"
#include "map/map.h"

namespace yorb {
namespace {

// Ids are dense, and a table has a pointer for each 64 of them: beyond any map that was ever made, within any memory.
constexpr uint32_t kMostKeyframes = 1u << 26, kMostLandmarks = 1u << 31;

std::string Name(KeyframeId id) { return "keyframe " + std::to_string(id.value()); }
std::string Name(LandmarkId id) { return "landmark " + std::to_string(id.value()); }

/// Whether the ids of the rows rise and stay below the next.
template <typename Row, typename RowId>
bool AreIdsSound(const std::vector<Row>& rows, RowId next) {
  for (size_t i = 0; i < rows.size(); ++i) {
    if (!(rows[i].id < next) || (i > 0 && !(rows[i - 1].id < rows[i].id))) return false;
  }
  return true;
}

/// Each child once, each with this parent, and no parent without the child.
std::string CheckChildren(const Map& map) {
  std::string broken;
  size_t num_children = 0, num_with_parent = 0;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    num_with_parent += keyframe.parent.IsValid();
    num_children += keyframe.children.size();
    std::vector<KeyframeId> children = keyframe.children;
    std::sort(children.begin(), children.end());
    if (std::adjacent_find(children.begin(), children.end()) != children.end()) {
      broken = Name(keyframe.id) + " has a child twice";
    }
  });
  if (broken.empty() && num_children != num_with_parent) broken = "a keyframe is not among its parent's children";
  return broken;
}

/// Whether every removed keyframe leads to one that is there, or to one of which nothing is known.
std::string CheckRemoved(const Map& map, const std::vector<RemovedKeyframe>& removed) {
  // A walk that takes more steps than there are removed keyframes goes in a circle; those of earlier walks are known.
  const auto row_of = [&](KeyframeId id) {
    return std::lower_bound(removed.begin(), removed.end(), id,
                            [](const RemovedKeyframe& row, KeyframeId wanted) { return row.id < wanted; });
  };
  std::vector<bool> is_sound(removed.size(), false);
  for (size_t i = 0; i < removed.size(); ++i) {
    std::vector<size_t> walk;
    for (size_t at = i; !is_sound[at];) {
      if (walk.size() == removed.size()) return Name(removed[i].id) + " follows itself";
      walk.push_back(at);
      const KeyframeId parent = removed[at].parent;
      if (!parent.IsValid() || map.Find(parent)) break;
      const auto next = row_of(parent);
      if (next == removed.end() || next->id != parent) return Name(removed[at].id) + " follows one that never was";
      at = static_cast<size_t>(next - removed.begin());
    }
    for (const size_t at : walk) is_sound[at] = true;
  }
  return {};
}

Status StatusOf(const std::string& broken) { return broken.empty() ? Status::Ok() : Status(BadInput(broken)); }

}  // namespace

std::vector<RemovedKeyframe> Map::RemovedKeyframes() const {
  std::vector<RemovedKeyframe> removed;
  for (uint32_t id = 0; id < keyframes_.next_id().value(); ++id) {
    if (Find(KeyframeId(id))) continue;
    const Past* past = FindPast(KeyframeId(id));
    removed.push_back(
        {KeyframeId(id), past ? past->parent : KeyframeId(), past ? past->cam_from_parent_cam : Rigid3::Identity()});
  }
  return removed;
}

Map Map::Continuing(const Map& snapshot) {
  Map map = snapshot;
  // The new writer must not write into pages that it shares with the snapshot: as after a snapshot of its own.
  map.keyframes_.Share();
  map.landmarks_.Share();
  map.past_.Share();
  return map;
}

Result<Map> Map::FromParts(MapParts parts) {
  if (parts.keyframes.size() + parts.removed.size() != parts.next_keyframe.value()) {
    return BadInput("its keyframes are not all there");
  }
  Map map;
  map.num_loops_ = parts.num_loops;
  Status status = map.TakeKeyframes(std::move(parts.keyframes), parts.next_keyframe);
  if (status) status = map.TakeRemoved(parts.removed);
  if (status) status = map.TakeLandmarks(std::move(parts.landmarks), parts.next_landmark);
  if (status) status = map.LinkViews();
  if (status) status = StatusOf(CheckChildren(map));
  if (status) map.FindRoots();
  if (status) status = StatusOf(map.Check());
  if (!status) return status.error();
  return map;
}

Status Map::TakeKeyframes(std::vector<Keyframe> keyframes, KeyframeId next) {
  if (next.value() > kMostKeyframes || !AreIdsSound(keyframes, next)) return BadInput("it has impossible keyframe ids");
  for (Keyframe& keyframe : keyframes) {
    newest_keyframe_ = keyframe.id;
    keyframes_.SkipTo(keyframe.id);
    keyframes_.Add(std::move(keyframe));
  }
  keyframes_.SkipTo(next);
  return Status::Ok();
}

void Map::FindRoots() {
  std::vector<KeyframeId> roots;
  VisitKeyframes([&](const Keyframe& keyframe) {
    if (!keyframe.parent.IsValid()) roots.push_back(keyframe.id);
  });
  // Every keyframe hangs below one root, or in a ring, which Check finds: then it is never reached.
  for (const KeyframeId root : roots) {
    std::vector<KeyframeId> below = {root};
    for (size_t i = 0; i < below.size(); ++i) {
      keyframes_.Writable(below[i]).root = root;
      for (const KeyframeId child : Find(below[i])->children) {
        if (Find(child) && !Find(child)->root.IsValid()) below.push_back(child);
      }
    }
  }
}

Status Map::TakeRemoved(const std::vector<RemovedKeyframe>& removed) {
  if (!AreIdsSound(removed, keyframes_.next_id())) return BadInput("it has impossible ids of removed keyframes");
  for (uint32_t id = 0; id < keyframes_.next_id().value(); ++id) past_.Add({});
  for (const RemovedKeyframe& row : removed) {
    if (Find(row.id)) return BadInput(Name(row.id) + " is there and removed");
    if (!row.cam_from_parent_cam.IsFinite()) return BadInput(Name(row.id) + " is nowhere");
    past_.Writable(Id<Past>(row.id.value())) = {row.parent, row.cam_from_parent_cam};
  }
  return StatusOf(CheckRemoved(*this, removed));
}

Status Map::TakeLandmarks(std::vector<Landmark> landmarks, LandmarkId next) {
  if (next.value() > kMostLandmarks || !AreIdsSound(landmarks, next)) return BadInput("it has impossible landmark ids");
  for (Landmark& landmark : landmarks) {
    if (!(landmark.first_keyframe < keyframes_.next_id())) {
      return BadInput(Name(landmark.id) + " was born in a keyframe that never was");
    }
    landmarks_.SkipTo(landmark.id);
    landmarks_.Add(std::move(landmark));
  }
  landmarks_.SkipTo(next);
  return Status::Ok();
}

Status Map::LinkViews() {
  std::string broken;
  std::vector<KeyframeId> ids;
  // Keyframes come by ascending id, and so do the views of each landmark.
  VisitKeyframes([&](const Keyframe& keyframe) {
    ids.push_back(keyframe.id);
    for (uint32_t i = 0; i < keyframe.landmarks.size() && broken.empty(); ++i) {
      const LandmarkId id = keyframe.landmarks[i];
      if (!id.IsValid()) continue;
      if (!Find(id)) {
        broken = Name(keyframe.id) + " sees " + Name(id) + ", which is not there";
        continue;
      }
      auto& views = landmarks_.Writable(id).views;
      if (!views.empty() && views.back().keyframe == keyframe.id) {
        broken = Name(keyframe.id) + " sees " + Name(id) + " twice";
      }
      views.push_back({keyframe.id, i});
    }
  });
  if (!broken.empty()) return BadInput(broken);
  SharedCounter counter;
  for (const KeyframeId id : ids) keyframes_.Writable(id).neighbours = counter.Count(*this, *Find(id));
  return Status::Ok();
}

}  // namespace yorb

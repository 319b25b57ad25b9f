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
      broken = NameOf(keyframe.id) + " has a child twice";
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
      if (walk.size() == removed.size()) return NameOf(removed[i].id) + " follows itself";
      walk.push_back(at);
      const KeyframeId parent = removed[at].parent;
      if (!parent.IsValid() || map.Find(parent)) break;
      const auto next = row_of(parent);
      if (next == removed.end() || next->id != parent) return NameOf(removed[at].id) + " follows one that never was";
      at = static_cast<size_t>(next - removed.begin());
    }
    for (const size_t at : walk) is_sound[at] = true;
  }
  return {};
}

Status StatusOf(const std::string& broken) { return broken.empty() ? Status::Ok() : Status(BadInput(broken)); }

}  // namespace

std::vector<RemovedKeyframe> MapAssembly::Removed(const Map& map) {
  std::vector<RemovedKeyframe> removed;
  for (uint32_t id = 0; id < map.next_keyframe().value(); ++id) {
    if (map.Find(KeyframeId(id))) continue;
    const Map::Past* past = map.FindPast(KeyframeId(id));
    removed.push_back(
        {KeyframeId(id), past ? past->parent : KeyframeId(), past ? past->cam_from_parent_cam : Rigid3::Identity()});
  }
  return removed;
}

Result<Map> MapAssembly::Make(MapParts parts) {
  if (parts.keyframes.size() + parts.removed.size() != parts.next_keyframe.value()) {
    return BadInput("its keyframes are not all there");
  }
  MapAssembly made;
  made.map_.num_loops_ = parts.num_loops;
  Status status = made.TakeKeyframes(std::move(parts.keyframes), parts.next_keyframe);
  if (status) status = made.TakeRemoved(parts.removed);
  if (status) status = made.TakeLandmarks(std::move(parts.landmarks), parts.next_landmark);
  if (status) status = made.LinkViews();
  if (status) status = StatusOf(CheckChildren(made.map_));
  if (status) made.FindRoots();
  if (status) status = StatusOf(made.map_.Check());
  if (!status) return status.error();
  return std::move(made.map_);
}

Status MapAssembly::TakeKeyframes(std::vector<Keyframe> keyframes, KeyframeId next) {
  if (next.value() > kMostKeyframes || !AreIdsSound(keyframes, next)) return BadInput("it has impossible keyframe ids");
  for (Keyframe& keyframe : keyframes) {
    map_.newest_keyframe_ = keyframe.id;
    keyframe.root = KeyframeId();
    map_.keyframes_.SkipTo(keyframe.id);
    map_.keyframes_.Add(std::move(keyframe));
  }
  map_.keyframes_.SkipTo(next);
  return Status::Ok();
}

/// Every keyframe hangs below one root, or in a ring, which Check finds: then it is never reached.
void MapAssembly::FindRoots() {
  std::vector<KeyframeId> roots;
  map_.VisitKeyframes([&](const Keyframe& keyframe) {
    if (!keyframe.parent.IsValid()) roots.push_back(keyframe.id);
  });
  for (const KeyframeId root : roots) {
    std::vector<KeyframeId> below = {root};
    for (size_t i = 0; i < below.size(); ++i) {
      map_.keyframes_.Writable(below[i]).root = root;
      for (const KeyframeId child : map_.Find(below[i])->children) {
        if (map_.Find(child) && !map_.Find(child)->root.IsValid()) below.push_back(child);
      }
    }
  }
}

Status MapAssembly::TakeRemoved(const std::vector<RemovedKeyframe>& removed) {
  if (!AreIdsSound(removed, map_.keyframes_.next_id())) return BadInput("it has impossible ids of removed keyframes");
  for (uint32_t id = 0; id < map_.keyframes_.next_id().value(); ++id) map_.past_.Add({});
  for (const RemovedKeyframe& row : removed) {
    if (map_.Find(row.id)) return BadInput(NameOf(row.id) + " is there and removed");
    if (!row.cam_from_parent_cam.IsFinite()) return BadInput(NameOf(row.id) + " is nowhere");
    map_.past_.Writable(Id<Map::Past>(row.id.value())) = {row.parent, row.cam_from_parent_cam};
  }
  return StatusOf(CheckRemoved(map_, removed));
}

Status MapAssembly::TakeLandmarks(std::vector<Landmark> landmarks, LandmarkId next) {
  if (next.value() > kMostLandmarks || !AreIdsSound(landmarks, next)) return BadInput("it has impossible landmark ids");
  for (Landmark& landmark : landmarks) {
    if (!(landmark.first_keyframe < map_.keyframes_.next_id())) {
      return BadInput(NameOf(landmark.id) + " was born in a keyframe that never was");
    }
    map_.landmarks_.SkipTo(landmark.id);
    map_.landmarks_.Add(std::move(landmark));
  }
  map_.landmarks_.SkipTo(next);
  return Status::Ok();
}

Status MapAssembly::LinkViews() {
  std::string broken;
  std::vector<KeyframeId> ids;
  // Keyframes come by ascending id, and so do the views of each landmark.
  map_.VisitKeyframes([&](const Keyframe& keyframe) {
    ids.push_back(keyframe.id);
    for (uint32_t i = 0; i < keyframe.landmarks.size() && broken.empty(); ++i) {
      const LandmarkId id = keyframe.landmarks[i];
      if (!id.IsValid()) continue;
      if (!map_.Find(id)) {
        broken = NameOf(keyframe.id) + " sees " + NameOf(id) + ", which is not there";
        continue;
      }
      auto& views = map_.landmarks_.Writable(id).views;
      if (!views.empty() && views.back().keyframe == keyframe.id) {
        broken = NameOf(keyframe.id) + " sees " + NameOf(id) + " twice";
      }
      views.push_back({keyframe.id, i});
    }
  });
  if (!broken.empty()) return BadInput(broken);
  SharedCounter counter;
  for (const KeyframeId id : ids) map_.keyframes_.Writable(id).neighbours = counter.Count(map_, *map_.Find(id));
  return Status::Ok();
}

}  // namespace yorb

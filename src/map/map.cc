// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/map.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "features/hamming.h"

namespace yorb {
namespace {

template <typename Views>
auto ViewAt(Views& views, KeyframeId keyframe) {
  return std::lower_bound(views.begin(), views.end(), keyframe,
                          [](const LandmarkView& view, KeyframeId id) { return view.keyframe < id; });
}

template <typename Neighbours>
auto NeighbourAt(Neighbours& neighbours, KeyframeId id) {
  return std::lower_bound(neighbours.begin(), neighbours.end(), id,
                          [](const Neighbour& neighbour, KeyframeId wanted) { return neighbour.id < wanted; });
}

/// The row whose median distance to the others is least.
size_t MostTypical(const std::vector<Descriptor>& descriptors) {
  const size_t n = descriptors.size();
  if (n < 3) return 0;
  std::vector<int> distances(n * n, 0);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = i + 1; j < n; ++j) {
      distances[i * n + j] = distances[j * n + i] = HammingDistance(descriptors[i], descriptors[j]);
    }
  }
  size_t best = 0;
  int best_median = 257;
  for (size_t i = 0; i < n; ++i) {
    const auto row = distances.begin() + static_cast<std::ptrdiff_t>(i * n);
    const auto middle = row + static_cast<std::ptrdiff_t>((n - 1) / 2);
    std::nth_element(row, middle, row + static_cast<std::ptrdiff_t>(n));
    if (*middle < best_median) {
      best_median = *middle;
      best = i;
    }
  }
  return best;
}

}  // namespace

const char* ToString(TrackingState state) {
  switch (state) {
    case TrackingState::kNotInitialized:
      return "not_initialized";
    case TrackingState::kTracking:
      return "tracking";
    case TrackingState::kRecentlyLost:
      return "recently_lost";
    case TrackingState::kLost:
      return "lost";
  }
  return "lost";
}

std::vector<KeyframeId> Keyframe::Strongest(size_t count, int min_weight) const {
  std::vector<Neighbour> strong;
  for (const Neighbour& n : neighbours) {
    if (n.weight >= min_weight) strong.push_back(n);
  }
  const size_t kept = std::min(count, strong.size());
  std::partial_sort(strong.begin(), strong.begin() + static_cast<std::ptrdiff_t>(kept), strong.end(),
                    [](const Neighbour& a, const Neighbour& b) {
                      return a.weight != b.weight ? a.weight > b.weight : b.id < a.id;  // of equals the newer
                    });
  std::vector<KeyframeId> ids;
  for (size_t i = 0; i < kept; ++i) ids.push_back(strong[i].id);
  return ids;
}

std::vector<KeyframeId> Keyframe::WithStrongest(size_t count, int min_weight) const {
  std::vector<KeyframeId> ids = Strongest(count, min_weight);
  ids.push_back(id);
  return ids;
}

int Keyframe::NumShared(KeyframeId other) const {
  const auto neighbour = NeighbourAt(neighbours, other);
  return neighbour != neighbours.end() && neighbour->id == other ? neighbour->weight : 0;
}

const LandmarkView* Landmark::ViewOf(KeyframeId keyframe) const {
  const auto view = ViewAt(views, keyframe);
  return view != views.end() && view->keyframe == keyframe ? &*view : nullptr;
}

int Landmark::PredictedOctave(double distance, const ScaleTable& scales) const {
  const double level = std::ceil(std::log(max_distance / distance) / std::log(scales.factor));
  return static_cast<int>(std::clamp(level, 0.0, static_cast<double>(scales.levels() - 1)));
}

LandmarkId Map::Resolve(LandmarkId id) const {
  for (auto next = merged_into_.find(id); next != merged_into_.end(); next = merged_into_.find(id)) id = next->second;
  return id;
}

const Map::Past* Map::FindPast(KeyframeId id) const {
  const Past* past = id.IsValid() ? past_.Find(Id<Past>(id.value())) : nullptr;
  return past && past->parent.IsValid() ? past : nullptr;
}

std::optional<Rigid3> Map::CamFromWorld(KeyframeId id) const {
  Rigid3 cam_from_ancestor;
  for (const Past* gone = FindPast(id); gone; gone = FindPast(id)) {
    cam_from_ancestor = cam_from_ancestor * gone->cam_from_parent_cam;
    id = gone->parent;
  }
  const Keyframe* keyframe = Find(id);
  if (!keyframe) return std::nullopt;
  return cam_from_ancestor * keyframe->cam_from_world;
}

std::vector<LandmarkId> Map::SeenBy(const std::vector<KeyframeId>& keyframes) const {
  std::vector<LandmarkId> ids;
  for (const KeyframeId keyframe : keyframes) {
    for (const LandmarkId id : Find(keyframe)->landmarks) {
      if (id.IsValid()) ids.push_back(id);
    }
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

KeyframeId Map::Surviving(KeyframeId id) const {
  for (const Past* gone = FindPast(id); gone; gone = FindPast(id)) id = gone->parent;
  return id;
}

MapSnapshot Map::Snapshot() {
  auto snapshot = std::make_shared<Map>();
  snapshot->keyframes_ = keyframes_.Share();
  snapshot->landmarks_ = landmarks_.Share();
  snapshot->past_ = past_.Share();
  snapshot->merged_into_ = merged_into_;
  snapshot->newest_keyframe_ = newest_keyframe_;
  snapshot->num_loops_ = num_loops_;
  return snapshot;
}

Map Map::Continuing(const Map& snapshot) {
  Map map = snapshot;
  // The new writer must not write into pages that it shares with the snapshot: as after a snapshot of its own.
  map.keyframes_.Share();
  map.landmarks_.Share();
  map.past_.Share();
  map.merged_into_.clear();  // nobody holds an older id
  return map;
}

KeyframeId Map::AddKeyframe(FramePtr frame, const Rigid3& cam_from_world, KeyframeId parent) {
  Keyframe keyframe;
  keyframe.id = keyframes_.next_id();
  keyframe.root = parent.IsValid() ? Find(parent)->root : keyframe.id;
  keyframe.cam_from_world = cam_from_world;
  keyframe.landmarks.resize(frame->size());
  keyframe.frame = std::move(frame);
  newest_keyframe_ = keyframes_.Add(std::move(keyframe));
  past_.Add({});
  ForgetOldMerges();
  if (parent.IsValid()) SetParent(newest_keyframe_, parent);
  return newest_keyframe_;
}

LandmarkId Map::AddLandmark(const Eigen::Vector3d& x_in_world, KeyframeId keyframe, uint32_t index) {
  Landmark landmark;
  landmark.id = landmarks_.next_id();
  landmark.position = x_in_world;
  landmark.reference = landmark.first_keyframe = keyframe;
  landmark.num_visible = landmark.num_found = 1;
  const LandmarkId id = landmarks_.Add(std::move(landmark));
  YORB_CHECK(Observe(id, keyframe, index), "a new landmark needs a keypoint without one");
  Refresh(id);
  return id;
}

bool Map::Observe(LandmarkId landmark, KeyframeId keyframe, uint32_t index) {
  const Landmark* seen = Find(landmark);
  const Keyframe* by = Find(keyframe);
  YORB_CHECK(seen && by && index < by->landmarks.size(), "both ends of an observation must be there");
  if (by->landmarks[index].IsValid() || seen->ViewOf(keyframe)) return false;
  for (const LandmarkView& view : seen->views) Link(view.keyframe, keyframe, +1);
  keyframes_.Writable(keyframe).landmarks[index] = landmark;
  auto& views = landmarks_.Writable(landmark).views;
  views.insert(ViewAt(views, keyframe), LandmarkView{keyframe, index});
  return true;
}

void Map::Unobserve(LandmarkId landmark, KeyframeId keyframe) {
  Landmark& seen = landmarks_.Writable(landmark);
  const auto view = ViewAt(seen.views, keyframe);
  YORB_CHECK(view != seen.views.end() && view->keyframe == keyframe, "a view that is taken away must be there");
  keyframes_.Writable(keyframe).landmarks[view->index] = LandmarkId();
  seen.views.erase(view);
  for (const LandmarkView& other : seen.views) Link(other.keyframe, keyframe, -1);
  if (seen.views.empty()) {
    landmarks_.Remove(landmark);
  } else if (seen.reference == keyframe) {
    seen.reference = seen.views.front().keyframe;
  }
}

void Map::Merge(LandmarkId from, LandmarkId into) {
  if (from == into) return;
  YORB_CHECK(Find(from) && Find(into), "both landmarks of a merge must be there");
  const Landmark leaving = *Find(from);
  Remove(from);
  for (const LandmarkView& view : leaving.views) Observe(into, view.keyframe, view.index);
  Count(into, leaving.num_visible, leaving.num_found);
  merged_into_.emplace(from, into);
  merges_.push_back({from, newest_keyframe_});
  Refresh(into);
}

void Map::Remove(LandmarkId id) {
  const std::vector<LandmarkView> views = landmarks_.Writable(id).views;
  for (const LandmarkView& view : views) Unobserve(id, view.keyframe);
}

void Map::Remove(KeyframeId id) {
  const Keyframe* found = Find(id);
  YORB_CHECK(found && found->parent.IsValid(), "the first keyframe of a sub-map stays");
  const Keyframe leaving = *found;
  for (const LandmarkId landmark : leaving.landmarks) {
    if (landmark.IsValid()) Unobserve(landmark, id);
  }
  AdoptChildren(leaving);
  DropChild(leaving.parent, id);
  for (const KeyframeId other : leaving.loops) {
    auto& loops = keyframes_.Writable(other).loops;
    loops.erase(std::find(loops.begin(), loops.end(), id));
  }
  past_.Writable(Id<Past>(id.value())) = {leaving.parent,
                                          leaving.cam_from_world * Find(leaving.parent)->cam_from_world.Inverse()};
  keyframes_.Remove(id);
  while (newest_keyframe_ == id || !Find(newest_keyframe_)) newest_keyframe_ = KeyframeId(newest_keyframe_.value() - 1);
}

void Map::AddLoop(KeyframeId a, KeyframeId b) {
  YORB_CHECK(Find(a) && Find(b) && a != b, "both ends of a loop must be there");
  ++num_loops_;
  const auto& known = Find(a)->loops;
  if (std::find(known.begin(), known.end(), b) != known.end()) return;
  keyframes_.Writable(a).loops.push_back(b);
  keyframes_.Writable(b).loops.push_back(a);
}

void Map::Join(KeyframeId joining, KeyframeId into) {
  YORB_CHECK(Find(joining) && Find(into), "both keyframes of a joint must be there");
  const KeyframeId old_root = Find(joining)->root, new_root = Find(into)->root;
  YORB_CHECK(old_root != new_root, "only different sub-maps can be joined");
  // The way from `joining` up to its root turns round.
  KeyframeId below = into;
  for (KeyframeId id = joining; id.IsValid();) {
    const KeyframeId above = Find(id)->parent;
    if (above.IsValid()) DropChild(above, id);
    SetParent(id, below);
    below = id;
    id = above;
  }
  std::vector<KeyframeId> joined;
  VisitKeyframes([&](const Keyframe& keyframe) {
    if (keyframe.root == old_root) joined.push_back(keyframe.id);
  });
  for (const KeyframeId id : joined) keyframes_.Writable(id).root = new_root;
}

void Map::RefreshGeometry(LandmarkId id) {
  Landmark& landmark = landmarks_.Writable(id);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const LandmarkView& view : landmark.views) {
    sum += (landmark.position - Find(view.keyframe)->cam_from_world.OriginInSource()).normalized();
  }
  landmark.view_direction = sum.normalized();

  const Keyframe& reference = *Find(landmark.reference);
  const Frame& frame = *reference.frame;
  const auto octave = static_cast<size_t>(frame.keypoints[landmark.ViewOf(landmark.reference)->index].octave);
  const double distance = (landmark.position - reference.cam_from_world.OriginInSource()).norm();
  landmark.max_distance = distance * frame.scales->scale[octave];
  landmark.min_distance = landmark.max_distance / frame.scales->scale.back();
}

void Map::Refresh(LandmarkId id) {
  RefreshGeometry(id);
  Landmark& landmark = landmarks_.Writable(id);
  std::vector<Descriptor> descriptors;
  for (const LandmarkView& view : landmark.views) {
    descriptors.push_back(Find(view.keyframe)->frame->descriptors[view.index]);
  }
  landmark.descriptor = descriptors[MostTypical(descriptors)];
}

void Map::Count(LandmarkId id, int visible, int found) {
  if (!Find(id)) return;
  Landmark& landmark = landmarks_.Writable(id);
  landmark.num_visible += visible;
  landmark.num_found += found;
}

void Map::ForgetOldMerges() {
  while (!merges_.empty() && merges_.front().newest_keyframe.value() + kMergesRemembered < newest_keyframe_.value()) {
    merged_into_.erase(merges_.front().from);
    merges_.pop_front();
  }
}

void Map::Link(KeyframeId a, KeyframeId b, int change) {
  for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
    auto& neighbours = keyframes_.Writable(one).neighbours;
    auto at = NeighbourAt(neighbours, other);
    if (at == neighbours.end() || at->id != other) at = neighbours.insert(at, Neighbour{other, 0});
    at->weight += change;
    if (at->weight == 0) neighbours.erase(at);
  }
}

void Map::AdoptChildren(const Keyframe& leaving) {
  for (const KeyframeId child : leaving.children) {
    // The sibling or grandparent that shares most with the child, of those that do not hang below it.
    KeyframeId best = leaving.parent;
    int best_weight = 0;
    for (const Neighbour& neighbour : Find(child)->neighbours) {
      const bool is_better = neighbour.id < child && neighbour.id != leaving.id && neighbour.weight > best_weight;
      if (is_better && !IsAbove(child, neighbour.id)) {
        best = neighbour.id;
        best_weight = neighbour.weight;
      }
    }
    SetParent(child, best);
  }
}

void Map::SetParent(KeyframeId child, KeyframeId parent) {
  YORB_CHECK(Find(child) && Find(parent), "a child and its parent must be there");
  keyframes_.Writable(child).parent = parent;
  keyframes_.Writable(parent).children.push_back(child);
}

void Map::DropChild(KeyframeId parent, KeyframeId child) {
  auto& children = keyframes_.Writable(parent).children;
  children.erase(std::find(children.begin(), children.end(), child));
}

bool Map::IsAbove(KeyframeId above, KeyframeId id) const {
  while (id.IsValid() && id != above) id = Find(id)->parent;
  return id == above;
}

}  // namespace yorb

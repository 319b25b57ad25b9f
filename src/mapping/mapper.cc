// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/mapper.h"

#include "core/stopwatch.h"
#include "mapping/cull.h"
#include "mapping/fuse.h"
#include "mapping/insert.h"
#include "mapping/triangulate_new.h"
#include "optimize/local_bundle.h"

namespace yorb {

Mapper::Mapper(const MappingOptions& options, VocabularyPtr vocabulary, Map start)
    : options_(options), vocabulary_(std::move(vocabulary)), map_(std::move(start)) {
  if (!vocabulary_) return;
  std::vector<KeyframeId> without;
  map_.VisitKeyframes([&](const Keyframe& keyframe) {
    if (!keyframe.bag) without.push_back(keyframe.id);
  });
  for (const KeyframeId id : without) Describe(id);
}

MappingTimes Mapper::Handle(const Proposal& proposal, const MapperHooks& hooks) {
  MappingTimes times;
  const Stopwatch total;
  const auto num_neighbours = static_cast<size_t>(options_.neighbours);

  const KeyframeId id = times.added = Insert(proposal);
  times.num_landmarks_gone = RemoveGone(map_, proposal.counts);
  times.insert_ms = total.ms();

  const Stopwatch triangulate;
  for (const LandmarkId added : TriangulateNew(map_, id, num_neighbours)) recent_.push_back(added);
  times.triangulate_ms = triangulate.ms();

  const Stopwatch fuse;
  FuseWithNeighbours(map_, id, num_neighbours);
  times.fuse_ms = fuse.ms();
  if (hooks.publish) hooks.publish(map_.Snapshot());

  const bool is_busy = hooks.is_busy && hooks.is_busy();
  if (map_.num_keyframes() > 1 && !is_busy) {
    const Stopwatch adjust;
    AdjustAround(id, hooks.is_busy);
    times.local_ba_ms = adjust.ms();
    times.has_adjusted = true;
    const Stopwatch cull;
    CullKeyframes(map_, id, options_.redundant_share);
    times.cull_ms = cull.ms();
  }
  times.total_ms = total.ms();
  return times;
}

KeyframeId Mapper::Insert(const Proposal& proposal) {
  const KeyframeId id = InsertKeyframe(map_, proposal);
  if (vocabulary_) Describe(id);
  recent_ = CullRecentLandmarks(map_, recent_);
  for (const LandmarkId added : AddLandmarksByDepth(map_, id)) recent_.push_back(added);
  return id;
}

void Mapper::Apply(const Correction& correction) {
  MoveMap(map_, correction);
  if (correction.place) TieTogether(*correction.place);
  TakeOut(correction.outliers);
}

void Mapper::TieTogether(const SamePlace& place) {
  constexpr size_t kNeighbours = 10;
  const KeyframeId newer = map_.Surviving(place.newer), older = map_.Surviving(place.older);
  if (newer == older) return;  // what has become one meanwhile needs no tie
  const std::vector<KeyframeId> ones = map_.Find(newer)->WithStrongest(kNeighbours, 1);
  const std::vector<KeyframeId> others = map_.Find(older)->WithStrongest(kNeighbours, 1);
  const KeyframeId newers_root = map_.Find(newer)->root, olders_root = map_.Find(older)->root;
  if (newers_root == olders_root) {
    map_.AddLoop(newer, older);
  } else if (olders_root < newers_root) {
    map_.Join(newer, older);
  } else {
    map_.Join(older, newer);
  }
  FuseAcross(map_, ones, others);
}

void Mapper::TakeOut(const std::vector<std::pair<LandmarkId, KeyframeId>>& outliers) {
  constexpr int kMinRays = 3;  // what one view with depth does not give
  for (const auto& [landmark, keyframe] : outliers) {
    const Landmark* seen = map_.Find(landmark);
    if (!seen || !seen->ViewOf(keyframe)) continue;
    map_.Unobserve(landmark, keyframe);
    const Landmark* left = map_.Find(landmark);
    if (left && NumRays(map_, *left) < kMinRays) map_.Remove(landmark);
  }
}

void Mapper::Describe(KeyframeId id) {
  map_.SetBag(id, std::make_shared<const Bag>(vocabulary_->Describe(map_.Find(id)->frame->descriptors)));
}

void Mapper::AdjustAround(KeyframeId center, const std::function<bool()>& should_stop) {
  LocalBundleOptions options;
  options.max_moving = static_cast<size_t>(options_.ba_keyframes);
  options.max_fixed = static_cast<size_t>(options_.ba_fixed_keyframes);
  const LocalBundle bundle = AdjustLocally(map_, center, options, should_stop);
  for (const auto& [id, pose] : bundle.poses) map_.SetPose(id, pose);
  for (const auto& [id, x_in_world] : bundle.points) map_.SetPosition(id, x_in_world);
  // What was stopped half-way judges nobody: its values are not yet those that fit best.
  if (!bundle.was_stopped) TakeOut(bundle.outliers);
  for (const auto& [id, x_in_world] : bundle.points) {
    if (map_.Find(id)) map_.RefreshGeometry(id);
  }
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looping/looper.h"

#include <algorithm>

#include "looping/close.h"
#include "optimize/global_bundle.h"

namespace yorb {

std::optional<Correction> Looper::Look(KeyframeId id, const Map& map) {
  if (!IsActive()) return std::nullopt;
  memory_.Follow(map);
  const Keyframe* keyframe = map.Find(id);  // it may have been culled by now
  if (!keyframe || !keyframe->bag) return std::nullopt;
  const auto recognition = Find(*keyframe, map);
  if (!recognition) return std::nullopt;
  if (options_.adjust_globally) wants_to_adjust_ = id;
  return Close(map, *recognition);
}

std::optional<Recognition> Looper::Find(const Keyframe& keyframe, const Map& map) {
  constexpr size_t kCandidates = 10;
  const auto may_be = [&](KeyframeId other) { return other < keyframe.id && !AreNear(map, keyframe.id, other); };
  for (const KeyframeId older : memory_.Recall(map, *keyframe.bag, kCandidates, may_be)) {
    const Random random(static_cast<uint64_t>(seed_), keyframe.id.value());
    const auto recognition = Recognize(map, keyframe, *map.Find(older), options_, random);
    if (!recognition || !IsPlausible(map, *recognition, options_)) continue;
    if (IsConfirmed(map, *recognition, options_) || IsSeenAgain(map, *recognition)) return recognition;
  }
  return std::nullopt;
}

/// Whether one of the last keyframes was recognized there, too; remembers this one for the next.
bool Looper::IsSeenAgain(const Map& map, const Recognition& recognition) {
  constexpr size_t kMostRemembered = 20;
  const auto agrees = [&](const Glimpse& glimpse) { return Agrees(map, recognition, glimpse); };
  if (std::any_of(glimpses_.begin(), glimpses_.end(), agrees)) return true;
  const Rigid3 older_from_world = map.Find(recognition.older)->cam_from_world;
  glimpses_.push_back({recognition.newer, recognition.older, recognition.cam_from_world * older_from_world.Inverse()});
  if (glimpses_.size() > kMostRemembered) glimpses_.pop_front();
  return false;
}

std::optional<Correction> Looper::Adjust(const Map& map, const std::function<bool()>& should_stop) {
  const Keyframe* within = map.Find(map.Surviving(wants_to_adjust_));
  std::vector<KeyframeId> keyframes;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (keyframe.root == within->root) keyframes.push_back(keyframe.id);
  });
  GlobalBundleOptions options;
  options.held = within->root;
  GlobalBundle bundle = AdjustGlobally(map, keyframes, options, should_stop);
  if (bundle.was_stopped) return std::nullopt;
  wants_to_adjust_ = KeyframeId();
  Correction correction;
  correction.poses = std::move(bundle.poses);
  correction.points = std::move(bundle.points);
  correction.outliers = std::move(bundle.outliers);
  return correction;
}

}  // namespace yorb

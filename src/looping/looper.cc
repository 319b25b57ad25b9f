// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looping/looper.h"

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

std::optional<Recognition> Looper::Find(const Keyframe& keyframe, const Map& map) const {
  constexpr size_t kCandidates = 10;
  const auto may_be = [&](KeyframeId other) { return other < keyframe.id && !AreNear(map, keyframe.id, other); };
  for (const KeyframeId older : memory_.Recall(map, *keyframe.bag, kCandidates, may_be)) {
    const Random random(static_cast<uint64_t>(seed_), keyframe.id.value());
    const auto recognition = Recognize(map, keyframe, *map.Find(older), options_, random);
    const bool holds =
        recognition && IsPlausible(map, *recognition, options_) && IsConfirmed(map, *recognition, options_);
    if (holds) return recognition;
  }
  return std::nullopt;
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

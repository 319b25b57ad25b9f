// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: looping. Recognises places that the camera has come back to, and says how the map must lie for it.
// Takes: keyframe ids, map snapshots. Gives: Corrections, which the mapper applies. Owns: its memory for places.
// Runs on: whichever thread calls. May not: change the map, start threads, read files.
#pragma once

#include <deque>
#include <functional>
#include <optional>

#include "localize/place_memory.h"
#include "looping/looping_options.h"
#include "looping/recognize.h"
#include "map/correction.h"

namespace yorb {

class Looper {
 public:
  Looper(const LoopingOptions& options, VocabularyPtr vocabulary, int64_t seed)
      : options_(options), memory_(std::move(vocabulary)), seed_(seed) {}

  /// Whether it can find anything at all.
  bool IsActive() const { return options_.close_loops && memory_.CanRecall(); }

  /// Looks whether a keyframe shows a place seen before: a loop, or another sub-map. `map` has the keyframe, and all
  /// corrections that were given before. Nothing in most cases.
  std::optional<Correction> Look(KeyframeId id, const Map& map);

  /// Whether something was closed since the last adjustment.
  bool WantsToAdjust() const { return wants_to_adjust_.IsValid(); }

  /// Bundle adjustment of the sub-map in which something was closed. Nothing where it was stopped before its end.
  std::optional<Correction> Adjust(const Map& map, const std::function<bool()>& should_stop);

 private:
  std::optional<Recognition> Find(const Keyframe& keyframe, const Map& map);
  bool IsSeenAgain(const Map& map, const Recognition& recognition);

  LoopingOptions options_;
  PlaceMemory memory_;
  int64_t seed_;
  KeyframeId wants_to_adjust_;    // a keyframe of the sub-map
  std::deque<Glimpse> glimpses_;  // the newest recognitions that nothing confirmed
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: mapping. Keeps the map: new keyframes and landmarks in, doubtful ones out, all of them where they fit best.
// Takes: Proposals. Gives: map snapshots. Owns: the map, as its only writer.
// Runs on: whichever thread calls Handle. May not: estimate the pose of a frame, start threads, read files.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "map/map.h"
#include "mapping/mapping_options.h"

namespace yorb {

/// What the mapper may ask and tell while it works on a keyframe.
struct MapperHooks {
  std::function<bool()> is_busy;  ///< more proposals wait: adjusting may be cut short; empty: never
  std::function<void(MapSnapshot)>
      publish;  ///< called once the new keyframe is in, before it is adjusted; may be empty
};

/// How long the parts took.
struct MappingTimes {
  double total_ms = 0;
  double insert_ms = 0, triangulate_ms = 0, fuse_ms = 0, local_ba_ms = 0, cull_ms = 0;
  bool has_adjusted = false;
};

class Mapper {
 public:
  /// `start`: the map to go on from.
  explicit Mapper(const MappingOptions& options, Map start = {}) : options_(options), map_(std::move(start)) {}

  /// Takes a proposal in. `Snapshot()` then shows what came of it.
  MappingTimes Handle(const Proposal& proposal, const MapperHooks& hooks);

  MapSnapshot Snapshot() { return map_.Snapshot(); }

 private:
  KeyframeId Insert(const Proposal& proposal);
  void AdjustAround(KeyframeId center, const std::function<bool()>& should_stop);

  MappingOptions options_;
  Map map_;
  std::vector<LandmarkId> recent_;  ///< landmarks that have to prove themselves
};

}  // namespace yorb

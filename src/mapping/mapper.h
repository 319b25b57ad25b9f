// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: mapping. Keeps the map: new keyframes and landmarks in, doubtful ones out, all of them where they fit best.
// Takes: Proposals, Corrections. Gives: map snapshots. Owns: the map, as its only writer.
// Runs on: whichever thread calls Handle. May not: estimate the pose of a frame, start threads, read files.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "map/correction.h"
#include "map/map.h"
#include "mapping/mapping_options.h"
#include "places/vocabulary.h"

namespace yorb {

/// What the mapper may ask and tell while it works on a keyframe.
struct MapperHooks {
  std::function<bool()> is_busy;  ///< more proposals wait: adjusting is left out, or ends early; empty: never
  std::function<void(MapSnapshot)>
      publish;  ///< called once the new keyframe is in, before it is adjusted; may be empty
};

/// What came of a proposal, and how long the parts took.
struct MappingTimes {
  KeyframeId added;
  double total_ms = 0;
  double insert_ms = 0, triangulate_ms = 0, fuse_ms = 0, local_ba_ms = 0, cull_ms = 0;
  bool has_adjusted = false;
  size_t num_landmarks_gone = 0;  ///< that turned out to move
};

class Mapper {
 public:
  /// Goes on from the map `start`. Without a vocabulary (null), keyframes have no bags of words.
  explicit Mapper(const MappingOptions& options, VocabularyPtr vocabulary = nullptr, Map start = {});

  /// Takes a proposal in. `Snapshot()` then shows what came of it.
  MappingTimes Handle(const Proposal& proposal, const MapperHooks& hooks);

  /// Moves the map; where the correction says that two keyframes show one place, ties them together: a loop, or two
  /// sub-maps that become one, with the landmarks there fused.
  void Apply(const Correction& correction);

  MapSnapshot Snapshot() { return map_.Snapshot(); }

 private:
  KeyframeId Insert(const Proposal& proposal);
  void Describe(KeyframeId id);
  void TieTogether(const SamePlace& place);
  void TakeOut(const std::vector<std::pair<LandmarkId, KeyframeId>>& outliers);
  void AdjustAround(KeyframeId center, const std::function<bool()>& should_stop);

  MappingOptions options_;
  VocabularyPtr vocabulary_;
  Map map_;
  std::vector<LandmarkId> recent_;  ///< landmarks that have to prove themselves
};

}  // namespace yorb

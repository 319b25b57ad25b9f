// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "features/frame.h"
#include "map/event.h"
#include "places/bag.h"

namespace yorb {

/// Another keyframe, and how many landmarks both see.
struct Neighbour {
  KeyframeId id;
  int weight = 0;
};

/// A frame that the map keeps. Written by Map's methods only.
struct Keyframe {
  KeyframeId id;
  FramePtr frame;
  Rigid3 cam_from_world;
  std::vector<LandmarkId> landmarks;  ///< a row a keypoint of the frame; not valid where nothing is known of it
  std::vector<Neighbour> neighbours;  ///< by ascending id; always the true counts
  KeyframeId root;                    ///< the first keyframe of its sub-map, in whose world all its poses are
  KeyframeId parent;                  ///< in the spanning tree; not valid for the root
  std::vector<KeyframeId> children;
  std::shared_ptr<const Bag> bag;  ///< the words of its descriptors; null: not known
  std::optional<Tie> tie;          ///< to an older keyframe
  LineSightsPtr lines;             ///< the straight edges of its picture; null: not known, as in map files
  std::vector<KeyframeId> loops;   ///< keyframes that were found to show the same place when a loop was closed

  /// The neighbours that share at least `min_weight` landmarks, the strongest first, `count` at most.
  std::vector<KeyframeId> Strongest(size_t count, int min_weight) const;

  /// The same, and the keyframe itself at the end: what is seen about there.
  std::vector<KeyframeId> WithStrongest(size_t count, int min_weight) const;

  /// How many landmarks it shares with another keyframe.
  int NumShared(KeyframeId other) const;
};

}  // namespace yorb

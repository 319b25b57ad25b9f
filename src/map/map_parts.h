// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/result.h"
#include "map/map.h"

namespace yorb {

/// What stays of a keyframe that is not there any more.
struct RemovedKeyframe {
  KeyframeId id;
  KeyframeId parent;  ///< that it follows; not valid: nothing is known of it
  Rigid3 cam_from_parent_cam;
};

/// A map taken apart. What follows from other parts is left out and computed anew: views of landmarks, neighbours.
/// Which landmarks were merged is forgotten, since nobody who reads a map from a file holds an older id.
struct MapParts {
  KeyframeId next_keyframe;  ///< that the next one will have: ids are never used again
  LandmarkId next_landmark;
  size_t num_loops = 0;                  ///< that were closed
  std::vector<Keyframe> keyframes;       ///< by ascending id, without neighbours, roots and bags
  std::vector<RemovedKeyframe> removed;  ///< by ascending id: all ids below the next that are not there
  std::vector<Landmark> landmarks;       ///< by ascending id, without views
};

/// Puts maps together from parts, and takes out what only Map itself can see.
class MapAssembly {
 public:
  /// The map of these parts. Bad input, in words, where they do not make one.
  static Result<Map> Make(MapParts parts);

  /// The keyframes of a map that are not there any more.
  static std::vector<RemovedKeyframe> Removed(const Map& map);

 private:
  Status TakeKeyframes(std::vector<Keyframe> keyframes, KeyframeId next);
  Status TakeRemoved(const std::vector<RemovedKeyframe>& removed);
  Status TakeLandmarks(std::vector<Landmark> landmarks, LandmarkId next);
  void FindRoots();
  Status LinkViews();

  Map map_;
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "map/map.h"
#include "motion/depth_grid.h"

namespace yorb {

/// Where a camera was: relative to a keyframe, so that it stays right when the map is corrected.
struct CameraPlace {
  KeyframeId reference;
  Rigid3 cam_from_reference;

  std::optional<Rigid3> CamFromWorld(const Map& map) const {
    const auto from_world = map.CamFromWorld(reference);
    if (!from_world) return std::nullopt;
    return cam_from_reference * *from_world;
  }
};

/// How far apart kept depth pictures are, and how long they say something.
constexpr double kViewIntervalS = 0.25, kViewLongestS = 3;

/// A depth picture, when it was taken and from where.
struct DepthView {
  Timestamp at;
  CameraPlace place;
  DepthGrid grid;
};

/// What earlier views of a place say of a cell.
struct CellPast {
  uint8_t num_compared = 0;       ///< views that saw anything at all there
  uint8_t num_seen_through = 0;   ///< views that saw something clearly behind it: it was not there yet
  uint8_t num_agreed = 0;         ///< views that saw it where it is now
  bool has_been_farther = false;  ///< a view saw something behind it, if only about its outline
};

/// How unsure the sensor's depth is, with what poses and shutters add: three standard deviations and a hand's breadth.
inline float DepthMargin(const Rig& rig, float metres) {
  constexpr float kBase = 0.1f, kSigmas = 3;
  return kBase + kSigmas * metres * metres / static_cast<float>(rig.VirtualBaselinePx());
}

/// Whether the camera sees through a point to something behind, on all sides of it.
bool IsSeenThrough(const DepthGrid& grid, const Rig& rig, const Eigen::Vector3d& x_in_cam);

/// The depth pictures of the last few seconds, some in a second.
class PastViews {
 public:
  /// Takes a view in where the newest is old enough, and lets go of the oldest.
  void Add(const DepthGrid& grid, Timestamp at, const CameraPlace& place);

  /// What the views say of the cells of a grid that was seen from `cam_from_world`, a row a cell.
  std::vector<CellPast> Compare(const DepthGrid& grid, const Rig& rig, const Rigid3& cam_from_world,
                                const Map& map) const;

  void Forget() { views_.clear(); }

 private:
  std::deque<DepthView> views_;  ///< in the order of time
};

}  // namespace yorb

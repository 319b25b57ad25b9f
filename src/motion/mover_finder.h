// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: motion. Finds by geometry alone what moves against a pose: whatever is where the camera saw through before.
// Takes: depth pictures, poses, map snapshots (for where keyframes are). Gives: MovingCells, and planes for poses
// (Surfaces). Owns: the depth pictures of the last seconds. Runs on: whichever thread calls. May not: know detectors,
// estimate poses, change the map.
#pragma once

#include <deque>
#include <vector>

#include "motion/moved_points.h"
#include "motion/past_views.h"

namespace yorb {

/// What of one picture moves.
class MovingCells {
 public:
  MovingCells() = default;

  /// `cells`: a row a cell of the grid, not 0 where something moves.
  MovingCells(const DepthGrid& grid, const Rig& rig, std::vector<uint8_t> cells);

  bool empty() const { return num_cells_ == 0; }
  int num_cells() const { return num_cells_; }
  const std::vector<uint8_t>& cells() const { return cells_; }

  /// Whether a point there, at so many metres (0: not known), is on what moves, or on its outline.
  bool Has(float x_px, float y_px, float metres) const;

 private:
  int num_cells_ = 0;
  DepthGrid shape_;  ///< its size alone
  std::vector<uint8_t> cells_;
  std::vector<float> farthest_;  ///< metres up to which a point belongs to what moves in or beside the cell; 0: nothing
};

/// A depth picture in which what moves counts as not measured.
DepthGrid WithoutMovers(DepthGrid grid, const MovingCells& moving);

/// Finds what moves in one picture after the other.
class MoverFinder {
 public:
  /// The newest picture, whose pose is known; pictures come in the order of time.
  MovingCells Find(PosedFrame now, const DepthGrid& grid, const Map& map);

  /// Nothing of before counts any more: the camera was lost.
  void Forget();

 private:
  struct Moved {
    Eigen::Vector3f x_in_cam;
    double age_s = 0;  ///< since it was last seen to move
  };

  std::vector<int> CellsThatWent(const PosedFrame& now, const DepthGrid& grid, const std::vector<CellPast>& past,
                                 const Map& map) const;
  void Remember(PosedFrame now);
  void AddFollowed(const DepthGrid& grid, const Rig& rig, const Rigid3& cam_from_last, double step_s,
                   std::vector<double>& age_s) const;

  PastViews past_;
  std::deque<PosedFrame> frames_;  ///< of a fraction of a second, in the order of time
  std::vector<Moved> moved_;       ///< of the last picture
};

}  // namespace yorb

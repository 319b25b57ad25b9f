// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/past_views.h"

#include <cmath>

namespace yorb {
namespace {

constexpr size_t kMostViews = 10;

/// How pixels with a depth go from one picture to another: (x, y, 1) z of the first becomes `turn` (x, y, 1) z +
/// `shift` of the second.
struct PixelTransfer {
  Eigen::Matrix3f turn;
  Eigen::Vector3f shift;

  PixelTransfer(const Pinhole& camera, const Rigid3& to_from_from) {
    Eigen::Matrix3d k;
    k << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1;
    turn = (k * to_from_from.rotation.toRotationMatrix() * k.inverse()).cast<float>();
    shift = (k * to_from_from.translation).cast<float>();
  }
};

/// Where the middle of a cell at its depth is seen.
Eigen::Vector3f MiddleOf(const DepthGrid& grid, int column, int row) {
  const float half = 0.5f * (kGridCellPx - 1);
  const float metres = grid.surface[static_cast<size_t>(row * grid.columns + column)];
  return metres * Eigen::Vector3f(static_cast<float>(column * kGridCellPx) + half,
                                  static_cast<float>(row * kGridCellPx) + half, 1);
}

void CompareWith(const DepthGrid& past, const DepthGrid& grid, const Rig& rig, const PixelTransfer& transfer,
                 std::vector<CellPast>& cells) {
  constexpr float kNearestM = 0.1f;
  size_t cell = 0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column, ++cell) {
      const float metres = grid.surface[cell];
      if (metres <= 0) continue;
      const Eigen::Vector3f there = transfer.turn * MiddleOf(grid, column, row) + transfer.shift;
      if (there.z() < kNearestM) continue;
      const int at = past.CellAt(there.x() / there.z(), there.y() / there.z());
      if (at < 0) continue;
      const float margin = DepthMargin(rig, there.z());
      const float surface = past.surface[static_cast<size_t>(at)];
      cells[cell].num_seen_through += past.free[static_cast<size_t>(at)] > there.z() + margin;
      cells[cell].num_compared += surface > 0 || past.free[static_cast<size_t>(at)] > 0;
      if (surface <= 0) continue;
      cells[cell].num_agreed += std::abs(surface - there.z()) < margin;
      cells[cell].has_been_farther |= surface > there.z() + margin;
    }
  }
}

}  // namespace

bool IsSeenThrough(const DepthGrid& grid, const Rig& rig, const Eigen::Vector3d& x_in_cam) {
  if (!(x_in_cam.z() > 0)) return false;
  const Eigen::Vector2f px = rig.camera.Project(x_in_cam).cast<float>();
  const int cell = grid.CellAt(px.x(), px.y());
  const auto metres = static_cast<float>(x_in_cam.z());
  return cell >= 0 && grid.free[static_cast<size_t>(cell)] > metres + DepthMargin(rig, metres);
}

void PastViews::Add(const DepthGrid& grid, Timestamp at, const CameraPlace& place) {
  while (!views_.empty() && SecondsBetween(views_.front().at, at) > kViewLongestS) views_.pop_front();
  if (grid.empty() || (!views_.empty() && SecondsBetween(views_.back().at, at) < kViewIntervalS)) return;
  if (views_.size() >= kMostViews) views_.pop_front();
  views_.push_back({at, place, grid});
}

std::vector<CellPast> PastViews::Compare(const DepthGrid& grid, const Rig& rig, const Rigid3& cam_from_world,
                                         const Map& map) const {
  std::vector<CellPast> cells(grid.surface.size());
  const Rigid3 world_from_cam = cam_from_world.Inverse();
  for (const DepthView& view : views_) {
    const auto past_from_world = view.place.CamFromWorld(map);
    if (!past_from_world || view.grid.columns != grid.columns || view.grid.rows != grid.rows) continue;
    CompareWith(view.grid, grid, rig, {rig.camera, *past_from_world * world_from_cam}, cells);
  }
  return cells;
}

}  // namespace yorb

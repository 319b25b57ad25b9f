// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/surfaces.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace yorb {
namespace {

constexpr size_t kMostSurfaces = 4;
constexpr int kStride = 2;             // every so many cells are paired, along rows and columns
constexpr double kNearestM = 0.1;      // in front of the earlier camera
constexpr double kLeastFacing = 0.15;  // cosine between a plane's normal and the ray that sees it

Eigen::Vector3d MiddleOf(const DepthGrid& grid, const Rig& rig, int cell) {
  const double half = 0.5 * (kGridCellPx - 1);
  const double x_px = cell % grid.columns * kGridCellPx + half, y_px = cell / grid.columns * kGridCellPx + half;
  return rig.camera.Unproject(x_px, y_px, grid.surface[static_cast<size_t>(cell)]);
}

/// The normal of the surface that goes through a cell and the four about it; zero where none does.
Eigen::Vector3d NormalAt(const DepthGrid& grid, const Rig& rig, int cell) {
  constexpr float kBase = 0.02f, kSlope = 0.04f;  // of the depth, from cell to cell
  const int column = cell % grid.columns, row = cell / grid.columns;
  const float metres = grid.surface[static_cast<size_t>(cell)];
  const bool is_inside = column > 0 && row > 0 && column + 1 < grid.columns && row + 1 < grid.rows;
  if (metres <= 0 || !is_inside) return Eigen::Vector3d::Zero();
  for (const int neighbour : {cell - 1, cell + 1, cell - grid.columns, cell + grid.columns}) {
    const float there = grid.surface[static_cast<size_t>(neighbour)];
    if (there <= 0 || std::abs(there - metres) > kBase + kSlope * metres) return Eigen::Vector3d::Zero();
  }
  const Eigen::Vector3d across = MiddleOf(grid, rig, cell + 1) - MiddleOf(grid, rig, cell - 1);
  const Eigen::Vector3d down = MiddleOf(grid, rig, cell + grid.columns) - MiddleOf(grid, rig, cell - grid.columns);
  return down.cross(across).normalized();
}

/// How unsure the distance of a point so far away from a surface is.
double SigmaAt(const Rig& rig, double metres) {
  constexpr double kBase = 0.01;
  return kBase + metres * metres / rig.VirtualBaselinePx();
}

/// What an earlier view says of a point of a later one: the plane there, as if the world began at the earlier camera.
std::optional<PlaneObservation> PairWith(const DepthGrid& past, const Rig& rig, const Rigid3& past_from_cam,
                                         const Eigen::Vector3d& x_in_cam) {
  constexpr double kReachM = 0.05, kReachSigmas = 3;
  const Eigen::Vector3d x_in_past = past_from_cam * x_in_cam;
  if (x_in_past.z() < kNearestM) return std::nullopt;
  const Eigen::Vector2f px = rig.camera.Project(x_in_past).cast<float>();
  const int cell = past.CellAt(px.x(), px.y());
  if (cell < 0) return std::nullopt;
  const Eigen::Vector3d normal = NormalAt(past, rig, cell);
  if (std::abs(normal.dot(x_in_past.normalized())) < kLeastFacing) return std::nullopt;
  const double offset = normal.dot(MiddleOf(past, rig, cell)), sigma_m = SigmaAt(rig, x_in_past.z());
  if (std::abs(normal.dot(x_in_past) - offset) > kReachM + kReachSigmas * sigma_m) return std::nullopt;
  return PlaneObservation{x_in_cam, normal, offset, sigma_m, 1};
}

}  // namespace

void Surfaces::Add(const DepthGrid& grid, Timestamp at, const CameraPlace& place) {
  if (grid.empty()) return;
  const size_t count = views_.size();
  if (count >= 2 && SecondsBetween(views_[count - 2].at, views_[count - 1].at) < kViewIntervalS) views_.pop_back();
  while (views_.size() >= kMostSurfaces || (!views_.empty() && SecondsBetween(views_.front().at, at) > kViewLongestS)) {
    views_.pop_front();
  }
  views_.push_back({at, place, grid});
}

std::vector<PlaneObservation> Surfaces::Pair(const DepthGrid& grid, const Rig& rig, const Rigid3& cam_from_world,
                                             const Map& map) const {
  std::vector<PlaneObservation> pairs;
  for (const DepthView& view : views_) {
    const auto past_from_world = view.place.CamFromWorld(map);
    if (!past_from_world || view.grid.columns != grid.columns || view.grid.rows != grid.rows) continue;
    const Rigid3 past_from_cam = *past_from_world * cam_from_world.Inverse();
    for (int row = 1; row + 1 < grid.rows; row += kStride) {
      for (int column = 1; column + 1 < grid.columns; column += kStride) {
        const int cell = row * grid.columns + column;
        if (grid.surface[static_cast<size_t>(cell)] <= 0) continue;
        auto pair = PairWith(view.grid, rig, past_from_cam, MiddleOf(grid, rig, cell));
        if (!pair) continue;
        pair->offset -= pair->normal_in_world.dot(past_from_world->translation);
        pair->normal_in_world = past_from_world->rotation.conjugate() * pair->normal_in_world;
        pairs.push_back(*pair);
      }
    }
  }
  const double weight = std::min(1.0, kMostWeight / static_cast<double>(std::max<size_t>(1, pairs.size())));
  for (PlaneObservation& pair : pairs) pair.weight = weight;
  return pairs;
}

}  // namespace yorb

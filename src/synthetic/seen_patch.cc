// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/seen_patch.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>

namespace yorb {
namespace {

RayFunction FromRow(const Eigen::RowVector3d& row) {
  return {static_cast<float>(row.x()), static_cast<float>(row.y()), static_cast<float>(row.z())};
}

void Include(const Eigen::Vector3d& x_in_cam, SeenPatch& seen) {
  // Rounded outwards by far more than a float's error.
  const auto x = static_cast<float>(x_in_cam.x() / x_in_cam.z()), y = static_cast<float>(x_in_cam.y() / x_in_cam.z());
  const float margin = 1e-5f * (1 + std::abs(x) + std::abs(y));
  seen.min_x = std::min(seen.min_x, x - margin);
  seen.max_x = std::max(seen.max_x, x + margin);
  seen.min_y = std::min(seen.min_y, y - margin);
  seen.max_y = std::max(seen.max_y, y + margin);
  seen.max_inverse_depth = std::max(seen.max_inverse_depth, static_cast<float>(1.0 / x_in_cam.z()) * (1 + 1e-5f));
}

// The bounds of the part of the patch that lies in front of the near plane; false when there is none.
bool FindBounds(const std::array<Eigen::Vector3d, 4>& corners, size_t num_corners, SeenPatch& seen) {
  constexpr float kFar = 1e9f;
  seen.min_x = seen.min_y = kFar;
  seen.max_x = seen.max_y = -kFar;
  for (size_t i = 0; i < num_corners; ++i) {
    const Eigen::Vector3d &a = corners[i], &b = corners[(i + 1) % num_corners];
    if (a.z() >= kNearDepth) Include(a, seen);
    if ((a.z() < kNearDepth) != (b.z() < kNearDepth)) {
      const Eigen::Vector3d cut = a + (kNearDepth - a.z()) / (b.z() - a.z()) * (b - a);
      Include({cut.x(), cut.y(), kNearDepth}, seen);
    }
  }
  return seen.min_x <= seen.max_x;
}

}  // namespace

std::optional<SeenPatch> SeePatch(const Patch& patch, const Rigid3& cam_from_world) {
  const Eigen::Matrix3d rotation = cam_from_world.rotation.toRotationMatrix();
  const Eigen::Vector3d corner = rotation * patch.corner.cast<double>() + cam_from_world.translation;
  const Eigen::Vector3d edge_s = rotation * patch.edge_s.cast<double>(),
                        edge_t = rotation * patch.edge_t.cast<double>();
  const Eigen::Vector3d across = edge_s.cross(edge_t);
  const double facing = -across.dot(corner);  // > 0: the front side is seen
  if (!patch.is_two_sided && facing <= 0) return std::nullopt;
  if (std::abs(facing) < 1e-5 * across.norm() * corner.norm() || across.norm() < 1e-12) return std::nullopt;

  SeenPatch seen;
  seen.patch = &patch;
  const std::array<Eigen::Vector3d, 4> triangle{corner, corner + edge_s, corner + edge_t};
  const std::array<Eigen::Vector3d, 4> parallelogram{corner, corner + edge_s, corner + edge_s + edge_t,
                                                     corner + edge_t};
  if (!FindBounds(patch.is_triangle ? triangle : parallelogram, patch.is_triangle ? 3 : 4, seen)) return std::nullopt;

  // corner + s edge_s + t edge_t = z ray, hence (s, t, 1) / z = [edge_s edge_t corner]^-1 ray.
  Eigen::Matrix3d columns;
  columns << edge_s, edge_t, corner;
  const Eigen::Matrix3d inverse = columns.inverse();
  seen.s = FromRow(inverse.row(0));
  seen.t = FromRow(inverse.row(1));
  seen.inverse_depth = FromRow(inverse.row(2));
  return seen;
}

}  // namespace yorb

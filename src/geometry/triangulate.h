// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "geometry/rigid3.h"

namespace yorb {

/// One camera that sees the point: its pose and the point's place on the plane z = 1 of its frame, which is
/// ((x_px - cx) / fx, (y_px - cy) / fy).
struct View {
  Rigid3 cam_from_world;
  Eigen::Vector2d point_on_plane;

  /// The direction from the camera to the point, of unit length, in world axes.
  Eigen::Vector3d DirectionInWorld() const {
    return cam_from_world.rotation.conjugate() * point_on_plane.homogeneous().normalized();
  }
};

/// The cosine of the angle between the rays of two views: near 1 there is no depth in them.
double ParallaxCosine(const View& a, const View& b);

/// The cosine of the angle under which a point sees two camera centres; 1 where the point lies on one of them.
double ParallaxCosine(const Eigen::Vector3d& x_in_world, const Eigen::Vector3d& centre_a,
                      const Eigen::Vector3d& centre_b);

/// A parallax of 1.15 degrees, below which depth from two views is noise.
constexpr double kMaxParallaxCosine = 0.9998;

/// The point that two views see: linear least squares, the rows weighted by inverse depth so that the errors are those
/// in the pictures. Nothing when the rays are too nearly parallel, the point lies behind a camera, or input is not
/// finite.
std::optional<Eigen::Vector3d> Triangulate(const View& a, const View& b,
                                           double max_parallax_cosine = kMaxParallaxCosine);

/// The same from two views or more; the parallax is that of the widest pair.
std::optional<Eigen::Vector3d> Triangulate(const std::vector<View>& views,
                                           double max_parallax_cosine = kMaxParallaxCosine);

}  // namespace yorb

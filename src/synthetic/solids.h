// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "synthetic/scene.h"

namespace yorb {

/// How a texture lies on a face: fitted (`tile` 0: the `part` of the texture fills the face), or at its own scale.
struct Look {
  int texture = 0;
  float tile = 0;                                    ///< metres that one texture spans; 0: fitted
  Eigen::Vector2f offset = Eigen::Vector2f::Zero();  ///< where the face begins in a texture at its own scale
  bool is_turned = false;                            ///< the texture's x runs upwards
  Eigen::Array4f part{0, 0, 1, 1};                   ///< left, top, width, height of a fitted texture
  bool is_glowing = false;                           ///< shines by itself (screens, lamps, windows)
};

/// The faces of a box; its front looks along -y, its top along +z.
enum class Face { kFront, kBack, kLeft, kRight, kTop, kBottom };

/// One face of a box of `size` whose bottom's centre is the origin of `world_from_box`.
Patch BoxFace(const Eigen::Isometry3f& world_from_box, const Eigen::Vector3f& size, Face face, const Look& look);

/// One slice of a turned shape: at `height` along z, with half axes along x and y.
struct Slice {
  float height = 0, half_x = 0, half_y = 0;
};

/// What a turned shape (cup, ball, arm) looks like.
struct TurnedLook {
  int texture = 0;
  float repeat_u = 1, repeat_v = 1;  ///< textures once round, and from the first slice to the last
  int person = 0;
  int num_sectors = 12;
};

/// Brightness at a point with a normal.
using LightFunction = std::function<float(const Eigen::Vector3f& x_in_world, const Eigen::Vector3f& normal)>;

/// Appends the skin of a shape turned around z (with elliptical slices, from low to high), as triangles that are lit
/// smoothly. The texture's u runs once round from behind (+y), so that its middle is in front (-y); v runs downwards.
void AppendTurned(const Eigen::Isometry3f& world_from_shape, const std::vector<Slice>& slices, const TurnedLook& look,
                  const LightFunction& light, std::vector<Patch>& patches);

/// The slices of an ellipsoid that stands on z = 0.
std::vector<Slice> EllipsoidSlices(float height, float half_x, float half_y, int num_slices);

}  // namespace yorb

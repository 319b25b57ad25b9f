// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "geometry/rigid3.h"
#include "synthetic/scene.h"

namespace yorb {

/// A linear function of a ray (x, y, 1).
struct RayFunction {
  float x = 0, y = 0, one = 0;

  float operator()(float ray_x, float ray_y) const { return x * ray_x + y * ray_y + one; }

  /// The largest value on a rectangle of rays.
  float Max(float min_x, float max_x, float min_y, float max_y) const {
    return (x > 0 ? x * max_x : x * min_x) + (y > 0 ? y * max_y : y * min_y) + one;
  }
};

/// A patch as one camera sees it. With the ray (x, y, 1), `inverse_depth` is 1/z of the point where the ray meets the
/// plane, and the patch's coordinates of that point are s / inverse_depth and t / inverse_depth. All three are linear
/// in the ray, so nothing needs clipping (homogeneous rasterisation after Olano and Greer).
struct SeenPatch {
  const Patch* patch = nullptr;
  RayFunction s, t, inverse_depth;
  float min_x = 0, max_x = 0, min_y = 0, max_y = 0;  ///< holds all rays that meet the patch
  float max_inverse_depth = 0;
};

/// Nearer than this nothing is drawn, as if it were behind the camera.
constexpr double kNearDepth = 0.05;

/// Nothing when the patch is behind the camera, turned away or seen edge on.
std::optional<SeenPatch> SeePatch(const Patch& patch, const Rigid3& cam_from_world);

}  // namespace yorb

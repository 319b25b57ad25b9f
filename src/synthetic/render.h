// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "camera/rig.h"
#include "geometry/rigid3.h"
#include "synthetic/scene.h"

namespace yorb {

/// The soft shadow under somebody who stands on the floor.
struct FloorShadow {
  Eigen::Vector2f centre = Eigen::Vector2f::Zero();
  float radius = 0.35f;   ///< metres
  float strength = 0.4f;  ///< share of the light that is gone in the middle
};

/// What changes from frame to frame beside the camera.
struct MovingThings {
  std::vector<Patch> patches;
  std::vector<FloorShadow> shadows;
};

/// A picture without any noise.
struct RenderedView {
  cv::Mat colour;  ///< CV_8UC3, BGR
  cv::Mat depth;   ///< CV_32FC1, metres along the optical axis at the pixel's centre; 0 where there is nothing
  cv::Mat mask;    ///< CV_8UC1, Patch::person at the pixel's centre
};

/// The rays of a camera, and the renderer that sends them out. Exact: every pixel's ray is met with every surface's
/// plane, so depth and colour agree with the pose to rounding, lens distortion included. Edges are smoothed by four
/// samples a pixel, textures by the area that the pixel sees.
class Renderer {
 public:
  explicit Renderer(const Pinhole& camera);

  RenderedView Render(const Scene& scene, const MovingThings& moving, const Rigid3& world_from_cam) const;

  // Pictures are drawn tile by tile, so that a patch costs little where it is not.
  static constexpr int kTileSide = 8, kNumSamples = 5;  ///< sample 0 is the pixel's centre
  static constexpr int kTilePixels = kTileSide * kTileSide, kTileSamples = kTilePixels * kNumSamples;

  /// Rays (x, y, 1) of one tile, sample by sample, and the rectangle that holds them.
  struct Tile {
    float x[kTileSamples], y[kTileSamples];
    float min_x, max_x, min_y, max_y;
  };

 private:
  Pinhole camera_;
  int tile_columns_ = 0, tile_rows_ = 0;
  std::vector<Tile> tiles_;
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: synthetic. Renders RGB-D sequences of textured rooms, with or without walking people, with exact truth.
// Takes: options and a seed. Gives: RenderedFrame in memory, or a sequence in TUM layout on disk.
// Owns: nothing that lasts. Runs on: whichever thread calls; a frame depends on the options and its number alone.
// May not: know features, maps or trackers.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "synthetic/texture.h"

namespace yorb {

/// A textured parallelogram, or the triangle that is half of it. Its points are corner + s * edge_s + t * edge_t with s
/// and t in [0, 1]; texture coordinates and light are linear in s and t. World frame: metres, z up. It is seen from
/// the side from which edge_s turns to edge_t counter-clockwise.
struct Patch {
  Eigen::Vector3f corner = Eigen::Vector3f::Zero();
  Eigen::Vector3f edge_s = Eigen::Vector3f::Zero(), edge_t = Eigen::Vector3f::Zero();
  Eigen::Vector2f uv = Eigen::Vector2f::Zero();
  Eigen::Vector2f uv_s = Eigen::Vector2f::Zero(), uv_t = Eigen::Vector2f::Zero();
  float light = 1, light_s = 0, light_t = 0;  ///< brightness where there is no light map
  int light_map = -1;                         ///< index into Scene::light_maps; none: -1
  int texture = 0;                            ///< index into Scene::textures
  int person = 0;                             ///< whose it is: 0 the room's, k the k-th person's
  bool is_triangle = false;                   ///< only s + t <= 1
  bool is_two_sided = false;                  ///< seen from behind as well
  bool is_floor = false;                      ///< people's soft shadows fall here
  bool is_glowing = false;                    ///< shines by itself: `light` stays as it is

  Eigen::Vector3f At(float s, float t) const { return corner + s * edge_s + t * edge_t; }
  Eigen::Vector3f Normal() const { return edge_s.cross(edge_t).normalized(); }
};

/// Brightness on a grid of nodes over a patch, s along the rows.
struct LightMap {
  int columns = 0, rows = 0;  ///< at least 2
  std::vector<float> nodes;

  /// Between the nodes, linearly; s and t in [0, 1].
  float At(float s, float t) const;
};

/// A glowing rectangle; shines to the side of its normal.
struct Lamp {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  Eigen::Vector3f half_u = Eigen::Vector3f::Zero(), half_v = Eigen::Vector3f::Zero();  ///< normal: half_u x half_v
  float power = 1;
};

/// All that stands still.
struct Scene {
  std::vector<Texture> textures;
  std::vector<Patch> patches;
  std::vector<LightMap> light_maps;
  std::vector<Lamp> lamps;
  std::vector<Eigen::AlignedBox3f> occluders;  ///< the larger things only: they cast the shadows
  float ambient = 0.8f;                        ///< light from everywhere
};

}  // namespace yorb

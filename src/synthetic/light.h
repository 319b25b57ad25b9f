// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "synthetic/scene.h"

namespace yorb {

/// How finely the light of the room is worked out.
struct LightOptions {
  float cell = 0.12f;    ///< metres between the nodes of the light maps
  int lamp_rays = 4;     ///< a lamp, for soft shadows; 0: no shadows at all, and no dark corners
  int corner_rays = 20;  ///< towards all sides, for the darkness of corners
  int num_threads = 1;
};

/// Brightness at a point with a normal, without shadows: what moving things are lit with.
float OpenLight(const Scene& scene, const Eigen::Vector3f& x_in_world, const Eigen::Vector3f& normal);

/// Works out the light on everything in the scene: light maps on large patches, one value on small ones. Triangles keep
/// the light they have.
void BakeLight(const LightOptions& options, Scene& scene);

}  // namespace yorb

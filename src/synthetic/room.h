// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "synthetic/route.h"
#include "synthetic/scene.h"

namespace yorb {

/// Which room to make.
struct RoomOptions {
  uint64_t seed = 1;        ///< decides on colours, pictures, books and what lies where
  int texture_size = 512;   ///< side of most textures in texels, a power of two
  bool has_shadows = true;  ///< soft shadows and dark corners; without them the room is ready sooner
  int num_threads = 1;      ///< for the work before the first frame; does not change the result
};

/// Where things happen in a room: cameras move and people walk without running into anything.
struct Stage {
  Eigen::Vector3d focus = Eigen::Vector3d::Zero();        ///< what the hand-held camera looks at
  Eigen::Vector3d stand = Eigen::Vector3d::Zero();        ///< where it is held
  Eigen::Vector3d loop_centre = Eigen::Vector3d::Zero();  ///< the walk round the room: an ellipse
  Eigen::Vector2d loop_radii = Eigen::Vector2d::Zero();
  std::vector<Route> routes;  ///< of people: round the desk, round the room
};

struct Room {
  Scene scene;
  Stage stage;
};

/// An office of 8 x 6 m: a desk that stands free, bookcases, cabinets, a sofa, pictures on plastered and brick walls.
Room MakeRoom(const RoomOptions& options);

}  // namespace yorb

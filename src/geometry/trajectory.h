// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/time.h"
#include "geometry/rigid3.h"

namespace yorb {

/// Where the camera was at one moment.
struct StampedPose {
  Timestamp timestamp;
  Rigid3 world_from_cam;
};

/// Poses in the order of their time.
using Trajectory = std::vector<StampedPose>;

/// TUM's text: a line `timestamp tx ty tz qx qy qz qw` a pose, with a decimal point in every locale.
std::string TumText(const Trajectory& trajectory);

}  // namespace yorb

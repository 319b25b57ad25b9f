// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/random.h"
#include "geometry/line_sight.h"
#include "geometry/rigid3.h"

namespace yorb {

/// Straight edges of a room whose walls stand along the axes of the world, `count` of each direction and as many that
/// run anyhow, as a camera that is turned like this sees them.
inline LineSightsPtr LinesOfARoom(const Eigen::Quaterniond& cam_from_world, int count, Random& random) {
  constexpr float kSigma = 0.01f;
  const auto any = [&] {
    return Eigen::Vector3d(random.Gaussian(), random.Gaussian(), random.Gaussian()).normalized();
  };
  std::vector<LineSight> lines;
  for (int k = 0; k < count; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis) + 0.3 * double{kSigma} * any();
      lines.push_back({(cam_from_world * along.cross(any()).normalized()).cast<float>(), kSigma});
    }
    lines.push_back({any().cast<float>(), kSigma});
  }
  return std::make_shared<const std::vector<LineSight>>(std::move(lines));
}

}  // namespace yorb

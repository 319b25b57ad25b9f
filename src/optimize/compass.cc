// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/compass.h"

#include "geometry/common_directions.h"

namespace yorb {

std::vector<Eigen::Vector3d> DirectionsOf(const Map& map, KeyframeId root) {
  constexpr float kHalved = 20;  // keyframes after which one counts half as much as the first
  constexpr size_t kEnoughKeyframes = 100;
  std::vector<const Keyframe*> seeing;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (keyframe.root == root && keyframe.lines) seeing.push_back(&keyframe);
  });
  const size_t step = (seeing.size() + kEnoughKeyframes - 1) / kEnoughKeyframes;
  std::vector<LinePlane> planes;
  for (size_t k = 0; k < seeing.size(); k += step) {
    const Eigen::Matrix3f world_from_cam =
        seeing[k]->cam_from_world.rotation.conjugate().toRotationMatrix().cast<float>();
    const float weight = kHalved / (kHalved + static_cast<float>(k));
    for (const LineSight& line : *seeing[k]->lines) {
      planes.push_back({world_from_cam * line.normal, weight / (line.sigma * line.sigma)});
    }
  }
  return CommonDirections(planes);
}

}  // namespace yorb

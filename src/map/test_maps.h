// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/map.h"
#include "map/synthetic_world.h"

namespace yorb {

/// Adds a sub-map to a map: keyframes of `world` at these poses, each the parent of the next, that know the true
/// landmarks they see, as if it was seen from a world of its own: `poses` are of the synthetic world,
/// `other_from_world` leads to that of the sub-map.
inline std::vector<KeyframeId> AddSubmap(Map& map, const SyntheticWorld& world, const std::vector<Rigid3>& poses,
                                         const Rigid3& other_from_world = {}) {
  std::vector<KeyframeId> keyframes;
  std::vector<LandmarkId> landmark_of;
  for (const Rigid3& pose : poses) {
    const uint32_t number = map.next_keyframe().value();
    const auto view = world.Look(pose, FrameId(number), Timestamp{int64_t{number} * 100000000});
    const KeyframeId parent = keyframes.empty() ? KeyframeId() : keyframes.back();
    keyframes.push_back(map.AddKeyframe(view.frame, pose * other_from_world.Inverse(), parent));
    for (uint32_t i = 0; i < view.points.size(); ++i) {
      if (landmark_of.size() <= view.points[i]) landmark_of.resize(view.points[i] + 1);
      LandmarkId& id = landmark_of[view.points[i]];
      if (!id.IsValid()) {
        id = map.AddLandmark(other_from_world * world.Position(view.points[i]), keyframes.back(), i);
      } else if (map.Observe(id, keyframes.back(), i)) {
        map.Refresh(id);
      }
    }
  }
  return keyframes;
}

/// Cameras along a line, all looking ahead.
inline std::vector<Rigid3> PosesAlongX(int num, double step_m, double from_m = 0) {
  std::vector<Rigid3> poses;
  for (int k = 0; k < num; ++k) {
    poses.push_back({Eigen::Quaterniond::Identity(), Eigen::Vector3d(-from_m - k * step_m, 0, 0)});
  }
  return poses;
}

}  // namespace yorb

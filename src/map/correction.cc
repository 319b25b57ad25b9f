// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/correction.h"

#include <unordered_map>

namespace yorb {
namespace {

using Poses = std::unordered_map<KeyframeId, Rigid3>;

/// Where a keyframe goes; nothing where it stays.
std::optional<Rigid3> NewPose(const Map& map, const Poses& corrected, const Keyframe& keyframe) {
  for (const Keyframe* at = &keyframe; at; at = map.Find(at->parent)) {
    const auto known = corrected.find(at->id);
    if (known == corrected.end()) continue;
    if (at == &keyframe) return known->second;
    return keyframe.cam_from_world * at->cam_from_world.Inverse() * known->second;
  }
  return std::nullopt;
}

}  // namespace

void MoveMap(Map& map, const Correction& correction) {
  const Poses corrected(correction.poses.begin(), correction.poses.end());
  Poses moved;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    const auto pose = NewPose(map, corrected, keyframe);
    if (pose) moved.emplace(keyframe.id, *pose);
  });
  const std::unordered_map<LandmarkId, Eigen::Vector3d> known(correction.points.begin(), correction.points.end());
  std::vector<std::pair<LandmarkId, Eigen::Vector3d>> positions;
  map.VisitLandmarks([&](const Landmark& landmark) {
    const auto given = known.find(landmark.id);
    const auto reference = moved.find(landmark.reference);
    if (given != known.end()) {
      positions.emplace_back(landmark.id, given->second);
    } else if (reference != moved.end()) {
      const Eigen::Vector3d x_in_cam = map.Find(landmark.reference)->cam_from_world * landmark.position;
      positions.emplace_back(landmark.id, reference->second.Inverse() * x_in_cam);
    }
  });
  for (const auto& [id, cam_from_world] : moved) map.SetPose(id, cam_from_world);
  for (const auto& [id, x_in_world] : positions) map.SetPosition(id, x_in_world);
  for (const auto& [id, x_in_world] : positions) map.RefreshGeometry(id);
}

}  // namespace yorb

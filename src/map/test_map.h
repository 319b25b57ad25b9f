// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "map/map_parts.h"
#include "map/synthetic_world.h"

namespace yorb {

/// The parts of a map of several rooms, each a sub-map of some keyframes, the camera going along the back wall: large
/// maps in a short time.
inline MapParts SyntheticMapParts(int num_rooms, int keyframes_a_room) {
  MapParts parts;
  uint32_t next_landmark = 0;
  for (int room = 0; room < num_rooms; ++room) {
    const SyntheticWorld world(static_cast<uint64_t>(room) + 1);
    std::vector<LandmarkId> landmark_of(5000);
    for (int k = 0; k < keyframes_a_room; ++k) {
      const auto number = static_cast<uint32_t>(parts.keyframes.size());
      const double along = -1.5 + 3.0 * k / keyframes_a_room;
      Keyframe keyframe;
      keyframe.id = KeyframeId(number);
      keyframe.cam_from_world = Rigid3(Eigen::Quaterniond::Identity(), Eigen::Vector3d(-along, 0, 0));
      const auto view =
          world.Look(keyframe.cam_from_world, FrameId(2 * number), Timestamp{number * int64_t{100000000}});
      keyframe.frame = view.frame;
      if (k > 0) {
        keyframe.parent = KeyframeId(number - 1);
        parts.keyframes.back().children.push_back(keyframe.id);
      }
      for (size_t i = 0; i < view.points.size(); ++i) {
        LandmarkId& id = landmark_of[view.points[i]];
        if (!id.IsValid()) {
          id = LandmarkId(next_landmark++);
          Landmark landmark;
          landmark.id = id;
          landmark.position = world.Position(view.points[i]);
          landmark.descriptor = view.frame->descriptors[i];
          landmark.reference = landmark.first_keyframe = keyframe.id;
          landmark.num_visible = landmark.num_found = 1;
          parts.landmarks.push_back(landmark);
        }
        keyframe.landmarks.push_back(id);
      }
      parts.keyframes.push_back(std::move(keyframe));
    }
  }
  parts.next_keyframe = KeyframeId(static_cast<uint32_t>(parts.keyframes.size()));
  parts.next_landmark = LandmarkId(next_landmark);
  return parts;
}

/// Adds a sub-map to a map: keyframes of `world` at these poses, each the parent of the next, that know the true
/// landmarks they see, as if it was seen from a world of its own: `poses` are of the synthetic world,
/// `other_from_world` leads to that of the sub-map.
inline std::vector<KeyframeId> AddSubmap(Map& map, const SyntheticWorld& world, const std::vector<Rigid3>& poses,
                                         const Rigid3& other_from_world = {}) {
  std::vector<KeyframeId> keyframes;
  std::vector<LandmarkId> landmark_of;
  for (const Rigid3& pose : poses) {
    const uint32_t number = map.next_keyframe().value();
    const auto view = world.Look(pose, FrameId(2 * number + 1), Timestamp{int64_t{number} * 100000000});
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

/// A map that has lived: keyframes and landmarks were removed, landmarks merged, moved and counted; a loop was closed,
/// one further sub-map joined, and another not.
inline Map LivedInMap(int num_rooms, int keyframes_a_room) {
  auto made = MapAssembly::Make(SyntheticMapParts(num_rooms, keyframes_a_room));
  YORB_CHECK(made.ok(), "the parts make a map");
  Map map = *std::move(made);
  std::vector<LandmarkId> landmarks;
  map.VisitLandmarks([&](const Landmark& landmark) { landmarks.push_back(landmark.id); });
  Random random(7);
  for (size_t i = 0; i + 10 < landmarks.size(); i += 10) {
    map.Remove(landmarks[i]);
    map.Merge(landmarks[i + 1], landmarks[i + 2]);
    map.SetPosition(landmarks[i + 3], {random.Gaussian(), random.Gaussian(), random.Gaussian()});
    map.Count(landmarks[i + 4], 5, 3);
    map.Refresh(landmarks[i + 5]);
  }
  const uint32_t num = map.next_keyframe().value();
  for (const uint32_t start : {2u, 3u}) {
    for (uint32_t k = start; k < num; k += start * start) {
      const Keyframe* found = map.Find(KeyframeId(k));
      if (found && found->parent.IsValid()) map.Remove(KeyframeId(k));
    }
  }
  for (uint32_t k = 0; k < num; k += 5) {
    if (!map.Find(KeyframeId(k))) continue;
    map.SetPose(KeyframeId(k), Rigid3(RotationFromVector({random.Gaussian(), 0, 1}), {0.1 * k, 1.0 / 3, 0}));
  }
  if (num_rooms > 1) map.Join(map.newest_keyframe(), KeyframeId(0));
  const auto joined = AddSubmap(map, SyntheticWorld(70), PosesAlongX(3, 0.1));
  map.Join(joined[1], KeyframeId(0));
  AddSubmap(map, SyntheticWorld(71), PosesAlongX(2, 0.1));
  map.AddLoop(joined[2], KeyframeId(0));
  return map;
}

}  // namespace yorb

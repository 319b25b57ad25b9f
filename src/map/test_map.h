// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

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
      keyframe.root = KeyframeId(number - static_cast<uint32_t>(k));
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

/// A map that has lived: keyframes and landmarks were removed, landmarks merged, moved and counted.
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
  map.AddLoop(KeyframeId(0), KeyframeId(1));
  if (num_rooms > 1) map.Join(map.newest_keyframe(), KeyframeId(0));
  return map;
}

}  // namespace yorb

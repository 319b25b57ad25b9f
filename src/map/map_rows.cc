// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/map_rows.h"

#include <cmath>
#include <utility>

#include "map/all_finite.h"

namespace yorb {
namespace {

constexpr size_t kPoseBytes = 7 * sizeof(double);
constexpr size_t kRemovedBytes = 2 * sizeof(uint32_t) + kPoseBytes;
constexpr size_t kLandmarkBytes = 5 * sizeof(uint32_t) + 8 * sizeof(double) + sizeof(Descriptor);

template <typename Kind>
void PutId(Id<Kind> id, ByteWriter& bytes) {
  bytes.Put(id.value());
}

template <typename Kind>
Id<Kind> GetId(ByteReader& bytes) {
  return Id<Kind>(bytes.Get<uint32_t>());
}

template <typename Kind>
void PutIds(const std::vector<Id<Kind>>& ids, ByteWriter& bytes) {
  static_assert(sizeof(Id<Kind>) == sizeof(uint32_t), "an id is its number");
  bytes.PutRow(reinterpret_cast<const uint32_t*>(ids.data()), ids.size());
}

template <typename Kind>
std::vector<Id<Kind>> GetIds(ByteReader& bytes, size_t count) {
  std::vector<Id<Kind>> ids;
  for (const uint32_t value : bytes.GetRow<uint32_t>(count)) ids.emplace_back(value);
  return ids;
}

void PutPose(const Rigid3& pose, ByteWriter& bytes) {
  bytes.PutRow(pose.rotation.coeffs().data(), 4);
  bytes.PutRow(pose.translation.data(), 3);
}

/// To the bit: the constructor of Rigid3 would normalise anew.
Rigid3 GetPose(ByteReader& bytes) {
  Rigid3 pose;
  bytes.TakeRow(pose.rotation.coeffs().data(), 4);
  bytes.TakeRow(pose.translation.data(), 3);
  return pose;
}

bool IsPose(const Rigid3& pose) {
  constexpr double kRounding = 1e-6;
  return pose.IsFinite() && std::abs(pose.rotation.norm() - 1) < kRounding;
}

/// The points of a frame, a column each of their properties.
void PutPoints(const Frame& frame, ByteWriter& bytes) {
  bytes.Put(static_cast<uint32_t>(frame.size()));
  for (const float Keypoint::*part : {&Keypoint::x, &Keypoint::y, &Keypoint::angle_rad, &Keypoint::response}) {
    for (const Keypoint& keypoint : frame.keypoints) bytes.Put(keypoint.*part);
  }
  for (const Keypoint& keypoint : frame.keypoints) bytes.Put(static_cast<uint8_t>(keypoint.octave));
  for (const Eigen::Vector2f& px : frame.points_px) bytes.PutRow(px.data(), 2);
  bytes.PutRow(frame.depth.data(), frame.size());
  bytes.PutRow(frame.right_px.data(), frame.size());
  for (const Descriptor& descriptor : frame.descriptors) bytes.PutRow(descriptor.data(), descriptor.size());
}

void GetPoints(ByteReader& bytes, Frame& frame) {
  constexpr size_t kBytesEach = 4 * sizeof(float) + 1 + 4 * sizeof(float) + sizeof(Descriptor);
  const size_t count = bytes.GetCount(kBytesEach);
  frame.keypoints.resize(count);
  for (float Keypoint::*part : {&Keypoint::x, &Keypoint::y, &Keypoint::angle_rad, &Keypoint::response}) {
    for (Keypoint& keypoint : frame.keypoints) keypoint.*part = bytes.Get<float>();
  }
  for (Keypoint& keypoint : frame.keypoints) keypoint.octave = bytes.Get<uint8_t>();
  frame.points_px.resize(count);
  for (Eigen::Vector2f& px : frame.points_px) bytes.TakeRow(px.data(), 2);
  frame.depth = bytes.GetRow<float>(count);
  frame.right_px = bytes.GetRow<float>(count);
  frame.descriptors.resize(count);
  for (Descriptor& descriptor : frame.descriptors) bytes.TakeRow(descriptor.data(), descriptor.size());
}

/// What others rely on. Ideal pixels of a strange lens and right pixels of a tiny depth may be anything.
bool ArePoints(const Frame& frame) {
  const int levels = frame.scales->levels();
  for (size_t i = 0; i < frame.size(); ++i) {
    const Keypoint& p = frame.keypoints[i];
    const float numbers[] = {p.x, p.y, p.angle_rad, frame.depth[i]};
    if (!AllFinite(numbers) || p.octave >= levels || frame.depth[i] < 0) return false;
  }
  return true;
}

}  // namespace

std::string KeyframeBytes(const Keyframe& keyframe, uint32_t setup) {
  const Frame& frame = *keyframe.frame;
  ByteWriter bytes;
  PutId(keyframe.id, bytes);
  PutId(keyframe.parent, bytes);
  PutPose(keyframe.cam_from_world, bytes);
  for (const auto* ids : {&keyframe.children, &keyframe.loops}) {
    bytes.Put(static_cast<uint32_t>(ids->size()));
    PutIds(*ids, bytes);
  }
  PutId(frame.id, bytes);
  bytes.Put(frame.timestamp.ns);
  bytes.Put(setup);
  PutPoints(frame, bytes);
  PutIds(keyframe.landmarks, bytes);
  return bytes.bytes();
}

std::optional<Keyframe> ReadKeyframe(std::string_view content, const std::vector<FrameSetup>& setups) {
  ByteReader bytes(content);
  Keyframe keyframe;
  keyframe.id = GetId<Keyframe>(bytes);
  keyframe.parent = GetId<Keyframe>(bytes);
  keyframe.cam_from_world = GetPose(bytes);
  for (auto* ids : {&keyframe.children, &keyframe.loops}) {
    *ids = GetIds<Keyframe>(bytes, bytes.GetCount(sizeof(uint32_t)));
  }
  const auto frame = std::make_shared<Frame>();
  frame->id = GetId<Frame>(bytes);
  frame->timestamp.ns = bytes.Get<int64_t>();
  const auto setup = bytes.Get<uint32_t>();
  GetPoints(bytes, *frame);
  keyframe.landmarks = GetIds<Landmark>(bytes, frame->size());
  if (!bytes.IsReadWhole() || setup >= setups.size() || !IsPose(keyframe.cam_from_world)) return std::nullopt;
  frame->rig = setups[setup].rig;
  frame->scales = setups[setup].scales;
  frame->bounds = setups[setup].bounds;
  if (!ArePoints(*frame)) return std::nullopt;
  frame->grid = Grid(frame->bounds, frame->points_px);
  keyframe.frame = frame;
  return keyframe;
}

void PutLandmark(const Landmark& landmark, ByteWriter& bytes) {
  PutId(landmark.id, bytes);
  PutId(landmark.reference, bytes);
  PutId(landmark.first_keyframe, bytes);
  bytes.Put(static_cast<int32_t>(landmark.num_visible));
  bytes.Put(static_cast<int32_t>(landmark.num_found));
  bytes.PutRow(landmark.position.data(), 3);
  bytes.PutRow(landmark.view_direction.data(), 3);
  bytes.Put(landmark.min_distance);
  bytes.Put(landmark.max_distance);
  bytes.PutRow(landmark.descriptor.data(), landmark.descriptor.size());
}

std::optional<std::vector<Landmark>> ReadLandmarks(std::string_view content) {
  ByteReader bytes(content);
  std::vector<Landmark> landmarks(content.size() / kLandmarkBytes);
  for (Landmark& landmark : landmarks) {
    landmark.id = GetId<Landmark>(bytes);
    landmark.reference = GetId<Keyframe>(bytes);
    landmark.first_keyframe = GetId<Keyframe>(bytes);
    landmark.num_visible = bytes.Get<int32_t>();
    landmark.num_found = bytes.Get<int32_t>();
    bytes.TakeRow(landmark.position.data(), 3);
    bytes.TakeRow(landmark.view_direction.data(), 3);
    landmark.min_distance = bytes.Get<double>();
    landmark.max_distance = bytes.Get<double>();
    bytes.TakeRow(landmark.descriptor.data(), landmark.descriptor.size());
    const double distances[] = {landmark.min_distance, landmark.max_distance};
    if (!landmark.position.allFinite() || !landmark.view_direction.allFinite() || !AllFinite(distances)) {
      return std::nullopt;
    }
    if (landmark.min_distance < 0 || landmark.num_visible < 0 || landmark.num_found < 0) return std::nullopt;
  }
  if (!bytes.IsReadWhole()) return std::nullopt;
  return landmarks;
}

void PutRemoved(const RemovedKeyframe& removed, ByteWriter& bytes) {
  PutId(removed.id, bytes);
  PutId(removed.parent, bytes);
  PutPose(removed.cam_from_parent_cam, bytes);
}

std::optional<std::vector<RemovedKeyframe>> ReadRemoved(std::string_view content) {
  ByteReader bytes(content);
  std::vector<RemovedKeyframe> removed(content.size() / kRemovedBytes);
  for (RemovedKeyframe& row : removed) {
    row.id = GetId<Keyframe>(bytes);
    row.parent = GetId<Keyframe>(bytes);
    row.cam_from_parent_cam = GetPose(bytes);
    if (!IsPose(row.cam_from_parent_cam)) return std::nullopt;
  }
  if (!bytes.IsReadWhole()) return std::nullopt;
  return removed;
}

}  // namespace yorb

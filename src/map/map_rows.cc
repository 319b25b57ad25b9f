// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/map_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace yorb {
namespace {

constexpr size_t kMostLevels = 64;
constexpr float kWidestPx = 30000;  // of a picture whose points fit into a grid

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

template <typename Row>
bool AllFinite(const Row& row) {
  return std::all_of(std::begin(row), std::end(row), [](auto value) { return std::isfinite(value); });
}

void PutRig(const Rig& rig, ByteWriter& bytes) {
  const Pinhole& c = rig.camera;
  for (const double value : {c.fx, c.fy, c.cx, c.cy}) bytes.Put(value);
  bytes.PutRow(c.distortion.data(), c.distortion.size());
  bytes.Put(static_cast<int32_t>(c.width));
  bytes.Put(static_cast<int32_t>(c.height));
  for (const double value : {rig.baseline_px, rig.close_factor, rig.depth_factor, rig.readout_s, rig.fps}) {
    bytes.Put(value);
  }
  bytes.PutText(rig.name);
}

Rig GetRig(ByteReader& bytes) {
  Rig rig;
  Pinhole& c = rig.camera;
  for (double* value : {&c.fx, &c.fy, &c.cx, &c.cy}) *value = bytes.Get<double>();
  bytes.TakeRow(c.distortion.data(), c.distortion.size());
  c.width = bytes.Get<int32_t>();
  c.height = bytes.Get<int32_t>();
  for (double* value : {&rig.baseline_px, &rig.close_factor, &rig.depth_factor, &rig.readout_s, &rig.fps}) {
    *value = bytes.Get<double>();
  }
  rig.name = bytes.GetText();
  return rig;
}

bool IsRig(const Rig& rig) {
  const Pinhole& c = rig.camera;
  const double numbers[] = {c.fx,          c.fy,   c.cx, c.cy, rig.baseline_px, rig.close_factor, rig.depth_factor,
                            rig.readout_s, rig.fps};
  return AllFinite(numbers) && AllFinite(c.distortion) && c.fx > 0 && c.fy > 0 && c.width > 0 && c.height > 0 &&
         rig.baseline_px > 0;
}

bool AreScales(const ScaleTable& scales) {
  const auto is_scale = [](float value) { return std::isfinite(value) && value > 0; };
  return std::isfinite(scales.factor) && scales.factor > 1 && !scales.scale.empty() &&
         std::all_of(scales.scale.begin(), scales.scale.end(), is_scale) &&
         std::all_of(scales.inverse_variance.begin(), scales.inverse_variance.end(), is_scale);
}

bool AreBounds(const PixelBounds& bounds) {
  const float numbers[] = {bounds.min_x, bounds.max_x, bounds.min_y, bounds.max_y};
  const float width = bounds.max_x - bounds.min_x, height = bounds.max_y - bounds.min_y;
  return AllFinite(numbers) && width > 0 && height > 0 && width < kWidestPx && height < kWidestPx;
}

std::optional<FrameSetup> GetSetup(ByteReader& bytes) {
  const Rig rig = GetRig(bytes);
  ScaleTable scales;
  scales.factor = bytes.Get<double>();
  const size_t levels = bytes.GetCount(2 * sizeof(float));
  if (levels > kMostLevels) return std::nullopt;
  scales.scale = bytes.GetRow<float>(levels);
  scales.inverse_variance = bytes.GetRow<float>(levels);
  PixelBounds bounds;
  for (float* value : {&bounds.min_x, &bounds.max_x, &bounds.min_y, &bounds.max_y}) *value = bytes.Get<float>();
  if (!bytes.ok() || !IsRig(rig) || !AreScales(scales) || !AreBounds(bounds)) return std::nullopt;
  return FrameSetup{std::make_shared<const Rig>(rig), std::make_shared<const ScaleTable>(std::move(scales)), bounds};
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

uint32_t FrameSetups::IndexOf(const Frame& frame) {
  ByteWriter bytes;
  PutRig(*frame.rig, bytes);
  bytes.Put(frame.scales->factor);
  bytes.Put(static_cast<uint32_t>(frame.scales->scale.size()));
  bytes.PutRow(frame.scales->scale.data(), frame.scales->scale.size());
  bytes.PutRow(frame.scales->inverse_variance.data(), frame.scales->scale.size());
  for (const float value : {frame.bounds.min_x, frame.bounds.max_x, frame.bounds.min_y, frame.bounds.max_y}) {
    bytes.Put(value);
  }
  const auto [at, is_new] = index_of_.emplace(bytes.bytes(), static_cast<uint32_t>(setups_.size()));
  if (is_new) setups_.push_back(bytes.bytes());
  return at->second;
}

std::string FrameSetups::Bytes() const {
  ByteWriter bytes;
  bytes.Put(static_cast<uint32_t>(setups_.size()));
  for (const std::string& setup : setups_) bytes.PutRow(setup.data(), setup.size());
  return bytes.bytes();
}

std::optional<std::vector<FrameSetup>> ReadFrameSetups(std::string_view content) {
  ByteReader bytes(content);
  std::vector<FrameSetup> setups;
  for (size_t left = bytes.GetCount(1); left > 0; --left) {
    auto setup = GetSetup(bytes);
    if (!setup) return std::nullopt;
    setups.push_back(*std::move(setup));
  }
  if (!bytes.IsReadWhole()) return std::nullopt;
  return setups;
}

std::string KeyframeBytes(const Keyframe& keyframe, uint32_t setup) {
  const Frame& frame = *keyframe.frame;
  ByteWriter bytes;
  PutId(keyframe.id, bytes);
  PutId(keyframe.parent, bytes);
  PutPose(keyframe.cam_from_world, bytes);
  bytes.Put(static_cast<uint32_t>(keyframe.children.size()));
  PutIds(keyframe.children, bytes);
  bytes.Put(static_cast<uint32_t>(keyframe.loops.size()));
  PutIds(keyframe.loops, bytes);
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
  keyframe.children = GetIds<Keyframe>(bytes, bytes.GetCount(sizeof(uint32_t)));
  keyframe.loops = GetIds<Keyframe>(bytes, bytes.GetCount(sizeof(uint32_t)));
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

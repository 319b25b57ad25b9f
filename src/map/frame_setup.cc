// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/frame_setup.h"

#include <utility>

#include "map/all_finite.h"

namespace yorb {
namespace {

constexpr size_t kMostLevels = 64;
constexpr float kWidestPx = 30000;  // of a picture whose points fit into a grid

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

}  // namespace yorb

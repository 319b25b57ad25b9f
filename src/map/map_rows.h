// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "map/bytes.h"
#include "map/map_parts.h"

namespace yorb {

/// What many frames have in common, so that a file holds it once.
struct FrameSetup {
  std::shared_ptr<const Rig> rig;
  std::shared_ptr<const ScaleTable> scales;
  PixelBounds bounds;
};

/// The setups of the frames that are written, equal ones once, in the order of their first frames.
class FrameSetups {
 public:
  uint32_t IndexOf(const Frame& frame);

  /// All of them, as bytes.
  std::string Bytes() const;

 private:
  std::map<std::string, uint32_t> index_of_;
  std::vector<std::string> setups_;
};

/// Rows of a map as bytes.
std::string KeyframeBytes(const Keyframe& keyframe, uint32_t setup);
void PutLandmark(const Landmark& landmark, ByteWriter& bytes);
void PutRemoved(const RemovedKeyframe& removed, ByteWriter& bytes);

/// The same read back; nothing where the bytes hold what cannot be: numbers that are not finite, rows that are cut, an
/// octave that no pyramid has.
std::optional<std::vector<FrameSetup>> ReadFrameSetups(std::string_view bytes);
std::optional<Keyframe> ReadKeyframe(std::string_view bytes, const std::vector<FrameSetup>& setups);
std::optional<std::vector<Landmark>> ReadLandmarks(std::string_view bytes);
std::optional<std::vector<RemovedKeyframe>> ReadRemoved(std::string_view bytes);

}  // namespace yorb

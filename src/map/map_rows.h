// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "map/bytes.h"
#include "map/frame_setup.h"
#include "map/map_parts.h"

namespace yorb {

/// Rows of a map as bytes.
std::string KeyframeBytes(const Keyframe& keyframe, uint32_t setup);
void PutLandmark(const Landmark& landmark, ByteWriter& bytes);
void PutRemoved(const RemovedKeyframe& removed, ByteWriter& bytes);

/// The same read back; nothing where the bytes hold what cannot be: numbers that are not finite, rows that are cut, an
/// octave that no pyramid has.
std::optional<Keyframe> ReadKeyframe(std::string_view bytes, const std::vector<FrameSetup>& setups);
std::optional<std::vector<Landmark>> ReadLandmarks(std::string_view bytes);
std::optional<std::vector<RemovedKeyframe>> ReadRemoved(std::string_view bytes);

}  // namespace yorb

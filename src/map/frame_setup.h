// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "features/frame.h"
#include "map/bytes.h"

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

/// Read back; nothing where the bytes hold what no camera, pyramid or picture is.
std::optional<std::vector<FrameSetup>> ReadFrameSetups(std::string_view bytes);

}  // namespace yorb

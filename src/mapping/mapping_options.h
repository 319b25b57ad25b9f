// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/options.h"

namespace yorb {

/// Options of the mapper; YAML group `mapping`.
struct MappingOptions {
  int ba_keyframes = 20;   ///< at most so many keyframes move in one local bundle adjustment

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("ba_keyframes", self.ba_keyframes, Range(1, 200));
  }
};

}  // namespace yorb

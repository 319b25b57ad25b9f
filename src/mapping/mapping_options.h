// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/options.h"

namespace yorb {

/// Options of the mapper; YAML group `mapping`.
struct MappingOptions {
  int neighbours = 10;           ///< keyframes with which new points are triangulated and old ones fused
  int ba_keyframes = 20;         ///< at most so many keyframes move in one local bundle adjustment
  int ba_fixed_keyframes = 40;   ///< at most so many more hold them in place
  double redundant_share = 0.9;  ///< a keyframe goes when so much of it is seen by three others

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("neighbours", self.neighbours, Range(1, 100));
    visit("ba_keyframes", self.ba_keyframes, Range(1, 200));
    visit("ba_fixed_keyframes", self.ba_fixed_keyframes, Range(1, 500));
    visit("redundant_share", self.redundant_share, Range(0.5, 1));
  }
};

}  // namespace yorb

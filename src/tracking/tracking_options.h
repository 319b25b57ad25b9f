// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/options.h"

namespace yorb {

/// Options of the tracker; YAML group `tracking`.
struct TrackingOptions {
  double lost_after_s = 0.5;   ///< without a confirmed pose for so long, "recently lost" becomes "lost"

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("lost_after_s", self.lost_after_s, Range(0, 60));
  }
};

}  // namespace yorb

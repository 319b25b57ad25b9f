// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "localize/fix.h"
#include "map/map.h"
#include "tracking/tracking_options.h"

namespace yorb {

/// What the decision for a keyframe depends on.
struct KeyframeQuestion {
  const Frame& frame;
  const Fix& fix;
  const Map& map;
  KeyframeId reference;
  double seconds_since_last = 0;  ///< since the last proposal
  int frames_since_last = 0;
  size_t backlog = 0;  ///< proposals that the mapper has not worked off
};

/// Whether this frame should be a keyframe: enough is new in it, or the last one is long ago, and the mapper can take
/// it.
bool IsKeyframeDue(const KeyframeQuestion& question, const TrackingOptions& options);

}  // namespace yorb

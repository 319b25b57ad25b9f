// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/trust.h"

#include <algorithm>
#include <cmath>

namespace yorb {

double TrustIn(const Landmark& landmark, const Map& map) {
  // Not all by time: who goes along with the camera stays in view for longer than what stands still.
  constexpr double kEnoughSeconds = 2, kAtOnce = 0.6;
  const Keyframe& first = *map.Find(landmark.views.front().keyframe);
  const Keyframe& last = *map.Find(landmark.views.back().keyframe);
  const double seconds = std::abs(SecondsBetween(first.frame->timestamp, last.frame->timestamp));
  const double by_views = std::min(static_cast<double>(landmark.views.size()) / Landmark::kGrownUp, 1.0);
  const double by_time = kAtOnce + (1 - kAtOnce) * std::min(seconds / kEnoughSeconds, 1.0);
  return std::max(by_views * by_time, kTrustInNew);
}

}  // namespace yorb

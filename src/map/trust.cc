// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/trust.h"

#include <algorithm>
#include <cmath>

namespace yorb {

double TrustIn(const Landmark& landmark, const Map& map) {
  constexpr double kEnoughSeconds = 2;
  const Keyframe& first = *map.Find(landmark.views.front().keyframe);
  const Keyframe& last = *map.Find(landmark.views.back().keyframe);
  const double seconds = std::abs(SecondsBetween(first.frame->timestamp, last.frame->timestamp));
  const double by_views = static_cast<double>(landmark.views.size()) / Landmark::kGrownUp;
  return std::clamp(std::min(by_views, seconds / kEnoughSeconds), kTrustInNew, 1.0);
}

}  // namespace yorb

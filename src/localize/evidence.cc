// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize/evidence.h"

#include <limits>

#include "localize/local_map.h"

namespace yorb {
namespace {

/// Whether the frame shows anything near the place of a landmark that is not in its way.
bool CouldBeSeen(const Frame& frame, const ExpectedLandmark& expected, double depth_m) {
  constexpr float kNearPx = 12;
  constexpr double kInFront = 0.85;  // of the landmark's depth
  float nearest = std::numeric_limits<float>::infinity();
  bool is_hidden = false;
  const Eigen::Vector2f& px = expected.area.px;
  frame.grid.VisitNear(px.x(), px.y(), kNearPx, [&](uint32_t index) {
    const float distance = (frame.points_px[index] - px).norm();
    if (distance > kNearPx || distance >= nearest) return;
    nearest = distance;
    is_hidden = frame.HasDepth(index) && frame.depth[index] < kInFront * depth_m;
  });
  return nearest <= kNearPx && !is_hidden;
}

}  // namespace

Evidence Weigh(const Frame& frame, const Map& map, const Fix& fix, const std::vector<KeyframeId>& keyframes) {
  Evidence evidence;
  evidence.num_found = evidence.num_expected = fix.num_inliers;
  LocalMap local;
  local.keyframes = keyframes;
  constexpr float kWidening = 1;
  for (const auto& expected : ExpectLocalLandmarks(map, local, frame, fix.cam_from_world, fix.matches, kWidening)) {
    const double depth_m = (fix.cam_from_world * expected.landmark->position).z();
    evidence.num_expected += CouldBeSeen(frame, expected, depth_m);
  }
  return evidence;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize/evidence.h"

#include <algorithm>
#include <cmath>
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

/// The area over which points scatter: the root of the determinant of their covariance.
class Scatter {
 public:
  void Add(const Eigen::Vector2f& px) {
    const Eigen::Vector2d x = px.cast<double>();
    ++count_;
    sum_ += x;
    squares_ += x * x.transpose();
  }
  double Area() const {
    if (count_ < 3) return 0;
    const double n = static_cast<double>(count_);
    const Eigen::Matrix2d covariance = squares_ / n - (sum_ / n) * (sum_ / n).transpose();
    return std::sqrt(std::max(covariance.determinant(), 0.0));
  }
  size_t count() const { return count_; }

 private:
  size_t count_ = 0;
  Eigen::Vector2d sum_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
};

}  // namespace

Evidence Weigh(const Frame& frame, const Map& map, const Fix& fix, const std::vector<KeyframeId>& keyframes) {
  constexpr float kWidening = 1;
  Scatter found, expected;
  for (size_t i = 0; i < frame.size(); ++i) {
    if (!fix.matches[i].IsValid()) continue;
    found.Add(frame.points_px[i]);
    expected.Add(frame.points_px[i]);
  }
  LocalMap local;
  local.keyframes = keyframes;
  for (const auto& landmark : ExpectLocalLandmarks(map, local, frame, fix.cam_from_world, fix.matches, kWidening)) {
    const double depth_m = (fix.cam_from_world * landmark.landmark->position).z();
    if (CouldBeSeen(frame, landmark, depth_m)) expected.Add(landmark.area.px);
  }
  Evidence evidence{expected.count(), found.count(), 0};
  if (expected.Area() > 0) evidence.spread = found.Area() / expected.Area();
  return evidence;
}

}  // namespace yorb

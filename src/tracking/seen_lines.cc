// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/seen_lines.h"

#include <cmath>

#include "features/line_segments.h"
#include "tracking/shutter.h"

namespace yorb {

LineSightsPtr SeeLines(const Sight& sight, const Frame& frame, const std::optional<CameraRate>& rate) {
  constexpr float kPixels = 0.7f;     // of one end against the other
  constexpr float kCrooked = 0.006f;  // a third of a degree: houses and shelves are not exact
  const Rig& rig = *frame.rig;
  const std::vector<LineSegment> segments = FindLineSegments(sight.grey, sight.covered);
  std::vector<Eigen::Vector2f> ends_px;
  ends_px.reserve(2 * segments.size());
  for (const LineSegment& segment : segments) {
    ends_px.push_back(segment.from_px);
    ends_px.push_back(segment.to_px);
  }
  const std::vector<Eigen::Vector2f> ideal_px = rig.camera.Undistort(ends_px);
  const float depth = DepthOfOthers(frame);
  const auto ray = [&](size_t i) {
    return WhenMiddleRowWasRead(rig, rate.value_or(CameraRate()), ideal_px[i], ends_px[i].y(), depth);
  };
  std::vector<LineSight> lines;
  lines.reserve(segments.size());
  for (size_t k = 0; k < segments.size(); ++k) {
    const Eigen::Vector3d normal = ray(2 * k).cross(ray(2 * k + 1));
    const float length_px = (ideal_px[2 * k + 1] - ideal_px[2 * k]).norm();
    if (!(normal.norm() > 0) || !(length_px > 0)) continue;
    lines.push_back({normal.normalized().cast<float>(), std::hypot(kPixels / length_px, kCrooked)});
  }
  return std::make_shared<const std::vector<LineSight>>(std::move(lines));
}

}  // namespace yorb

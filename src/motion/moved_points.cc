// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/moved_points.h"

#include <algorithm>
#include <cmath>

#include "matching/search.h"

namespace yorb {
namespace {

constexpr int kLeastCompanions = 4;

/// A keypoint and the way it went, in the camera of now.
struct Way {
  uint32_t index = 0;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
};

/// Whether a shift is more than keypoints, depth and poses may be off.
bool IsSignificant(const Frame& frame, uint32_t index, const Eigen::Vector3d& shift) {
  constexpr double kCornerSigmaPx = 2, kRelativeDepthSigma = 0.01, kSigmas2 = 25;
  constexpr double kLeastM = 0.03, kLeastShare = 0.02;  // of the depth
  const double metres = frame.depth[index];
  const double scale = frame.scales->scale[static_cast<size_t>(frame.keypoints[index].octave)];
  const double across_m = kCornerSigmaPx * scale * metres / frame.rig->camera.fx;
  const double along_m = std::sqrt(2) * metres * metres / frame.rig->VirtualBaselinePx() + kRelativeDepthSigma * metres;
  const double across2 = shift.head<2>().squaredNorm() / (across_m * across_m);
  const double along2 = shift.z() * shift.z() / (along_m * along_m);
  return across2 + along2 > kSigmas2 && shift.norm() > kLeastM + kLeastShare * metres;
}

/// The ways of the points that are alike in both frames.
std::vector<Way> FindWays(const PosedFrame& then, const PosedFrame& now, const Rigid3& now_from_then) {
  constexpr double kFastest = 1.5, kRatio = 0.8;  // m/s
  constexpr float kWidestPx = 100;
  const Frame &from = *then.frame, &to = *now.frame;
  const double reach_m = kFastest * SecondsBetween(from.timestamp, to.timestamp);
  const auto is_free = [&](uint32_t i) { return !now.is_known[i] && to.HasDepth(i); };
  std::vector<Way> ways;
  for (size_t i = 0; i < from.size(); ++i) {
    if (then.is_known[i] || !from.HasDepth(i)) continue;
    const Eigen::Vector3d x_in_cam = now_from_then * from.PointInCam(i);
    if (x_in_cam.z() <= reach_m) continue;
    SearchArea area;
    area.px = to.rig->camera.Project(x_in_cam).cast<float>();
    area.radius_px = std::min(static_cast<float>(reach_m * to.rig->camera.fx / x_in_cam.z()), kWidestPx);
    area.min_octave = from.keypoints[i].octave - 1;
    area.max_octave = from.keypoints[i].octave + 1;
    const SearchResult found = FindNearest(to, area, from.descriptors[i], is_free);
    if (found.index < 0 || found.distance > kStrictDistance || found.distance > kRatio * found.second_distance)
      continue;
    const auto index = static_cast<uint32_t>(found.index);
    const Eigen::Vector3d shift = to.PointInCam(index) - x_in_cam;
    if (shift.norm() < reach_m && IsSignificant(to, index, shift)) ways.push_back({index, shift});
  }
  return ways;
}

bool IsNear(const Frame& frame, uint32_t a, uint32_t b) {
  constexpr float kNearPx = 80, kNearM = 0.25f;
  return (frame.points_px[a] - frame.points_px[b]).squaredNorm() < kNearPx * kNearPx &&
         std::abs(frame.depth[a] - frame.depth[b]) < kNearM;
}

/// Whether two points near each other go the same way.
bool GoTogether(const Frame& frame, const Way& a, const Way& b) {
  constexpr double kBaseM = 0.02, kShare = 0.3;
  return IsNear(frame, a.index, b.index) && (a.shift - b.shift).norm() < kBaseM + kShare * a.shift.norm();
}

}  // namespace

std::vector<uint32_t> FindMovedPoints(const PosedFrame& then, const PosedFrame& now, const Rigid3& now_from_then) {
  const Frame& frame = *now.frame;
  const std::vector<Way> ways = FindWays(then, now, now_from_then);
  std::vector<uint32_t> moved;
  for (const Way& way : ways) {
    const auto num_companions = std::count_if(ways.begin(), ways.end(), [&](const Way& other) {
      return other.index != way.index && GoTogether(frame, way, other);
    });
    if (num_companions < kLeastCompanions) continue;
    std::ptrdiff_t num_still = 0;
    for (uint32_t i = 0; i < frame.size(); ++i) num_still += now.is_known[i] && IsNear(frame, i, way.index);
    if (num_companions > num_still) moved.push_back(way.index);
  }
  return moved;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/by_projection.h"

#include <algorithm>
#include <cmath>

namespace yorb {
namespace {

/// How a camera that moved along its axis sees the octaves of the frame before.
struct OctaveRange {
  int below = 1, above = 1;
};

OctaveRange OctavesAfter(const Frame& frame, const Rigid3& cam_from_world, const Rigid3& last_cam_from_world) {
  const double baseline = frame.rig->VirtualBaselinePx() / frame.rig->camera.fx;
  const Eigen::Vector3d center_in_last = last_cam_from_world * cam_from_world.OriginInSource();
  if (center_in_last.z() > baseline) return {0, frame.scales->levels()};   // forward: things grew
  if (center_in_last.z() < -baseline) return {frame.scales->levels(), 0};  // backward: things shrank
  return {1, 1};
}

/// Whether a keypoint may be a point of the map at all: a suspect only one that is known well, and by its depth.
bool IsOpen(const Frame& frame, uint32_t index, bool is_grown_up) {
  return !frame.IsSuspect(index) || (is_grown_up && frame.HasDepth(index));
}

/// Whether what resembles a point may be it: a suspect must resemble it more.
bool IsAlike(const Frame& frame, const SearchResult& found) {
  if (found.index < 0) return false;
  return found.distance <= (frame.IsSuspect(static_cast<size_t>(found.index)) ? kStrictDistance : kLooseDistance);
}

float RightOf(const Frame& frame, double x_px, double depth) {
  return static_cast<float>(x_px - frame.rig->VirtualBaselinePx() / depth);
}

}  // namespace

std::vector<int> MatchKnownPoints(const Frame& frame, const Rigid3& cam_from_world, const Rigid3& last_cam_from_world,
                                  const std::vector<KnownPoint>& points, float radius_px) {
  const OctaveRange octaves = OctavesAfter(frame, cam_from_world, last_cam_from_world);
  Claims claims(frame.size());
  for (size_t row = 0; row < points.size(); ++row) {
    const KnownPoint& point = points[row];
    const auto is_free = [&](uint32_t index) { return IsOpen(frame, index, point.is_grown_up); };
    const Eigen::Vector3d x_in_cam = cam_from_world * point.x_in_world;
    if (x_in_cam.z() <= 0) continue;
    const Eigen::Vector2d px = frame.rig->camera.Project(x_in_cam);
    if (!frame.bounds.Contains(static_cast<float>(px.x()), static_cast<float>(px.y()))) continue;
    SearchArea area;
    area.px = px.cast<float>();
    area.right_px = RightOf(frame, px.x(), x_in_cam.z());
    area.radius_px = radius_px * frame.scales->scale[static_cast<size_t>(point.octave)];
    area.min_octave = point.octave - octaves.below;
    area.max_octave = point.octave + octaves.above;
    const SearchResult found = FindNearest(frame, area, point.descriptor, is_free);
    if (IsAlike(frame, found)) {
      claims.Claim(found.index, static_cast<int>(row), found.distance);
    }
  }
  std::vector<float> turn_rad(frame.size(), 0.f);
  for (size_t i = 0; i < frame.size(); ++i) {
    const int owner = claims.owners()[i];
    if (owner >= 0) turn_rad[i] = points[static_cast<size_t>(owner)].angle_rad - frame.keypoints[i].angle_rad;
  }
  DropOddTurns(turn_rad, claims);
  return claims.owners();
}

std::optional<SearchArea> ExpectLandmark(const Landmark& landmark, const Frame& frame, const Rigid3& cam_from_world,
                                         float widening) {
  constexpr double kMinViewCosine = 0.5, kFrontalCosine = 0.998;
  constexpr float kFrontalRadiusPx = 2.5f, kSlantedRadiusPx = 4.f;
  constexpr double kDistanceSlack = 0.2;  // scale invariance does not end at the outermost levels
  const Eigen::Vector3d x_in_cam = cam_from_world * landmark.position;
  if (x_in_cam.z() <= 0) return std::nullopt;
  const Eigen::Vector2d px = frame.rig->camera.Project(x_in_cam);
  if (!frame.bounds.Contains(static_cast<float>(px.x()), static_cast<float>(px.y()))) return std::nullopt;
  const Eigen::Vector3d ray = landmark.position - cam_from_world.OriginInSource();
  const double distance = ray.norm();
  if (distance < (1 - kDistanceSlack) * landmark.min_distance ||
      distance > (1 + kDistanceSlack) * landmark.max_distance) {
    return std::nullopt;
  }
  const double cosine = ray.dot(landmark.view_direction) / distance;
  if (cosine < kMinViewCosine) return std::nullopt;

  const int octave = landmark.PredictedOctave(distance, *frame.scales);
  SearchArea area;
  area.px = px.cast<float>();
  area.right_px = RightOf(frame, px.x(), x_in_cam.z());
  area.radius_px = widening * (cosine > kFrontalCosine ? kFrontalRadiusPx : kSlantedRadiusPx) *
                   frame.scales->scale[static_cast<size_t>(octave)];
  area.min_octave = octave - 1;
  area.max_octave = octave;
  return area;
}

std::vector<int> MatchExpected(const Frame& frame, const std::vector<ExpectedLandmark>& expected,
                               const std::vector<bool>& taken) {
  constexpr double kRatio = 0.8;
  Claims claims(frame.size());
  for (size_t row = 0; row < expected.size(); ++row) {
    const Landmark& landmark = *expected[row].landmark;
    const bool is_grown_up = landmark.IsGrownUp();
    const auto is_free = [&](uint32_t index) { return !taken[index] && IsOpen(frame, index, is_grown_up); };
    const SearchResult found = FindNearest(frame, expected[row].area, landmark.descriptor, is_free);
    if (IsAlike(frame, found) && !found.IsAmbiguous(kRatio)) {
      claims.Claim(found.index, static_cast<int>(row), found.distance);
    }
  }
  return claims.owners();
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/epipolar.h"

#include <cmath>

namespace yorb {
namespace {

/// The fundamental matrix: x_second^T F x_first = 0 for ideal pixels.
Eigen::Matrix3f Fundamental(const Keyframe& first, const Keyframe& second) {
  const Rigid3 second_from_first = second.cam_from_world * first.cam_from_world.Inverse();
  const Eigen::Matrix3d essential = Skew(second_from_first.translation) * second_from_first.rotation.toRotationMatrix();
  const auto inverse_of = [](const Pinhole& c) {
    Eigen::Matrix3d k;
    k << c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1;
    return Eigen::Matrix3d(k.inverse());
  };
  const Eigen::Matrix3d f =
      inverse_of(second.frame->rig->camera).transpose() * essential * inverse_of(first.frame->rig->camera);
  return f.cast<float>();
}

std::vector<uint32_t> Unknown(const Keyframe& keyframe) {
  std::vector<uint32_t> indices;
  for (uint32_t i = 0; i < keyframe.landmarks.size(); ++i) {
    if (!keyframe.landmarks[i].IsValid()) indices.push_back(i);
  }
  return indices;
}

/// Matches a keypoint with depth: it is known where it must appear.
SearchResult MatchWithDepth(const Keyframe& first, uint32_t index, const Keyframe& second) {
  constexpr float kRadiusPx = 5;
  const Frame& to = *second.frame;
  const Eigen::Vector3d x_in_world = first.cam_from_world.Inverse() * first.frame->PointInCam(index);
  const Eigen::Vector3d x_in_cam = second.cam_from_world * x_in_world;
  if (x_in_cam.z() <= 0) return {};
  const Eigen::Vector2d px = to.rig->camera.Project(x_in_cam);
  if (!to.bounds.Contains(static_cast<float>(px.x()), static_cast<float>(px.y()))) return {};
  const int octave = first.frame->keypoints[index].octave;
  SearchArea area;
  area.px = px.cast<float>();
  area.radius_px = kRadiusPx * to.scales->scale[static_cast<size_t>(octave)];
  area.min_octave = octave - 1;
  area.max_octave = octave + 1;
  const auto is_unknown = [&](uint32_t i) { return !second.landmarks[i].IsValid(); };
  return FindNearest(to, area, first.frame->descriptors[index], is_unknown);
}

/// Matches a keypoint without depth among those near its epipolar line.
SearchResult MatchOnLine(const Keyframe& first, uint32_t index, const Keyframe& second,
                         const std::vector<uint32_t>& candidates, const Eigen::Matrix3f& fundamental) {
  constexpr float kChi2OneResidual = 3.84f;  // 95 %
  const Eigen::Vector3f line = fundamental * first.frame->points_px[index].homogeneous();
  const float norm2 = line.head<2>().squaredNorm();
  const int octave = first.frame->keypoints[index].octave;
  SearchResult result;
  if (norm2 == 0) return result;
  for (const uint32_t j : candidates) {
    const float distance_px = line.dot(second.frame->points_px[j].homogeneous());
    if (distance_px * distance_px * second.frame->InverseVariance(j) > kChi2OneResidual * norm2) continue;
    if (std::abs(second.frame->keypoints[j].octave - octave) > 1) continue;
    const int distance = HammingDistance(first.frame->descriptors[index], second.frame->descriptors[j]);
    if (distance < result.distance) {
      result.distance = distance;
      result.index = static_cast<int>(j);
    }
  }
  return result;
}

}  // namespace

std::vector<KeypointPair> MatchUnknown(const Keyframe& first, const Keyframe& second) {
  const Eigen::Matrix3f fundamental = Fundamental(first, second);
  const std::vector<uint32_t> candidates = Unknown(second);
  Claims claims(second.frame->size());
  for (const uint32_t index : Unknown(first)) {
    const SearchResult found = first.frame->HasDepth(index)
                                   ? MatchWithDepth(first, index, second)
                                   : MatchOnLine(first, index, second, candidates, fundamental);
    if (found.index >= 0 && found.distance <= kStrictDistance) {
      claims.Claim(found.index, static_cast<int>(index), found.distance);
    }
  }
  std::vector<float> turn_rad(second.frame->size(), 0.f);
  for (size_t j = 0; j < turn_rad.size(); ++j) {
    const int owner = claims.owners()[j];
    if (owner < 0) continue;
    turn_rad[j] = first.frame->keypoints[static_cast<size_t>(owner)].angle_rad - second.frame->keypoints[j].angle_rad;
  }
  DropOddTurns(turn_rad, claims);
  std::vector<KeypointPair> pairs;
  for (uint32_t j = 0; j < turn_rad.size(); ++j) {
    const int owner = claims.owners()[j];
    if (owner >= 0) pairs.push_back({static_cast<uint32_t>(owner), j});
  }
  return pairs;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/triangulate_new.h"

#include <cmath>
#include <optional>

#include "geometry/triangulate.h"
#include "matching/epipolar.h"
#include "optimize/observed.h"

namespace yorb {
namespace {

/// Whether a point lies where a keypoint saw it, within the uncertainty of the keypoint's octave.
bool FitsView(const Keyframe& keyframe, uint32_t index, const Eigen::Vector3d& x_in_world) {
  const Eigen::Vector3d x_in_cam = keyframe.cam_from_world * x_in_world;
  if (!(x_in_cam.z() > 0)) return false;
  const Projection projection(*keyframe.frame->rig);
  const Observation seen = Observed(*keyframe.frame, index);
  const double x_px = projection.fx * x_in_cam.x() / x_in_cam.z() + projection.cx;
  const double y_px = projection.fy * x_in_cam.y() / x_in_cam.z() + projection.cy;
  double error2 = (x_px - seen.x_px) * (x_px - seen.x_px) + (y_px - seen.y_px) * (y_px - seen.y_px);
  if (!seen.HasDepth()) return error2 * seen.inverse_variance < kChi2Mono;
  const double right_px = x_px - projection.baseline_px / x_in_cam.z();
  error2 += (right_px - seen.right_px) * (right_px - seen.right_px);
  return error2 * seen.inverse_variance < kChi2Stereo;
}

/// The cosine of the angle between the rays that the depth of a keypoint is measured by; 1 where it has none.
double DepthParallaxCosine(const Frame& frame, uint32_t index) {
  if (!frame.HasDepth(index)) return 1;
  const double half_baseline = 0.5 * frame.rig->VirtualBaselinePx() / frame.rig->camera.fx;
  return std::cos(2 * std::atan2(half_baseline, frame.depth[index]));
}

/// Whether the octaves of both keypoints agree with the distances from which they saw the point.
bool FitsScales(const Keyframe& first, const Keyframe& second, KeypointPair pair, const Eigen::Vector3d& x_in_world) {
  constexpr double kSlack = 1.5;
  const ScaleTable& scales = *first.frame->scales;
  const auto scale_of = [&](const Keyframe& keyframe, uint32_t index) {
    return scales.scale[static_cast<size_t>(keyframe.frame->keypoints[index].octave)];
  };
  const double first_distance = (x_in_world - first.cam_from_world.OriginInSource()).norm();
  const double second_distance = (x_in_world - second.cam_from_world.OriginInSource()).norm();
  const double by_distance = second_distance / first_distance;
  const double by_octave = scale_of(first, pair.first) / scale_of(second, pair.second);
  const double slack = kSlack * scales.factor;
  return by_distance * slack > by_octave && by_distance < by_octave * slack;
}

/// The point by the widest of the angles under which it was seen: between the keyframes, or by the depth of either.
std::optional<Eigen::Vector3d> Locate(const Keyframe& first, const Keyframe& second, KeypointPair pair) {
  const auto view_of = [](const Keyframe& keyframe, uint32_t index) {
    const Eigen::Vector2f& px = keyframe.frame->points_px[index];
    return View{keyframe.cam_from_world, keyframe.frame->rig->camera.Unproject(px.x(), px.y(), 1).head<2>()};
  };
  const View first_view = view_of(first, pair.first), second_view = view_of(second, pair.second);
  const double first_depth = DepthParallaxCosine(*first.frame, pair.first);
  const double second_depth = DepthParallaxCosine(*second.frame, pair.second);
  if (ParallaxCosine(first_view, second_view) < std::min(first_depth, second_depth)) {
    return Triangulate(first_view, second_view);
  }
  if (first_depth < second_depth) return first.cam_from_world.Inverse() * first.frame->PointInCam(pair.first);
  if (second_depth < 1) return second.cam_from_world.Inverse() * second.frame->PointInCam(pair.second);
  return std::nullopt;
}

}  // namespace

std::vector<LandmarkId> TriangulateNew(Map& map, KeyframeId keyframe, size_t num_neighbours) {
  std::vector<LandmarkId> added;
  const auto center = [&]() -> const Keyframe& { return *map.Find(keyframe); };
  for (const KeyframeId neighbour : center().Strongest(num_neighbours, 1)) {
    const double baseline = center().frame->rig->VirtualBaselinePx() / center().frame->rig->camera.fx;
    const Keyframe& other = *map.Find(neighbour);
    const double distance = (center().cam_from_world.OriginInSource() - other.cam_from_world.OriginInSource()).norm();
    if (distance < baseline) continue;  // depth says more than so short a way
    for (const KeypointPair pair : MatchUnknown(center(), other)) {
      const Keyframe& second = *map.Find(neighbour);
      const auto x_in_world = Locate(center(), second, pair);
      if (!x_in_world || !FitsView(center(), pair.first, *x_in_world) || !FitsView(second, pair.second, *x_in_world) ||
          !FitsScales(center(), second, pair, *x_in_world)) {
        continue;
      }
      const LandmarkId id = map.AddLandmark(*x_in_world, keyframe, pair.first);
      map.Observe(id, neighbour, pair.second);
      map.Refresh(id);
      added.push_back(id);
    }
  }
  return added;
}

}  // namespace yorb

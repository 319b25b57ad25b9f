// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/map_bundle.h"

#include <algorithm>
#include <unordered_map>

#include "optimize/compass.h"
#include "optimize/observed.h"

namespace yorb {
namespace {

/// A bundle problem and what its rows are called in the map.
struct NamedProblem {
  BundleProblem problem;
  std::vector<KeyframeId> keyframes;
  std::vector<LandmarkId> landmarks;
};

void AddKeyframe(const Map& map, KeyframeId id, bool is_fixed, NamedProblem& named) {
  named.keyframes.push_back(id);
  named.problem.poses.push_back(map.Find(id)->cam_from_world);
  named.problem.is_fixed.push_back(is_fixed);
}

using RowOf = std::unordered_map<KeyframeId, uint32_t>;

RowOf RowsOf(const std::vector<KeyframeId>& keyframes) {
  RowOf row_of;
  for (uint32_t row = 0; row < keyframes.size(); ++row) row_of[keyframes[row]] = row;
  return row_of;
}

void AddLandmarks(const Map& map, const RowOf& row_of, NamedProblem& named) {
  for (uint32_t row = 0; row < named.landmarks.size(); ++row) {
    const Landmark& landmark = *map.Find(named.landmarks[row]);
    named.problem.points.push_back(landmark.position);
    for (const LandmarkView& view : landmark.views) {
      const auto pose = row_of.find(view.keyframe);
      if (pose == row_of.end()) continue;
      named.problem.seen.push_back({pose->second, row, Observed(*map.Find(view.keyframe)->frame, view.index)});
    }
  }
}

/// Ties between keyframes of the problem. Where the other one was culled, what it hung on stands for it.
void AddTies(const Map& map, const RowOf& row_of, NamedProblem& named) {
  for (uint32_t row = 0; row < named.keyframes.size(); ++row) {
    const std::optional<Tie>& tie = map.Find(named.keyframes[row])->tie;
    if (!tie) continue;
    const KeyframeId surviving = map.Surviving(tie->other);
    const auto other = row_of.find(surviving);
    if (other == row_of.end() || other->second == row) continue;
    const Rigid3 other_from_surviving = *map.CamFromWorld(tie->other) * map.Find(surviving)->cam_from_world.Inverse();
    named.problem.ties.push_back({other->second, row, tie->cam_from_other * other_from_surviving, tie->information});
  }
}

/// The direction that a line seen from a pose is nearest to; null where it runs otherwise.
const Eigen::Vector3d* NearestOf(const std::vector<Eigen::Vector3d>& directions,
                                 const Eigen::Vector3d& normal_in_world) {
  constexpr double kNear = 0.07;  // the sine of 4 degrees: further off than turns drift between keyframes
  const Eigen::Vector3d* nearest = nullptr;
  double least = kNear;
  for (const Eigen::Vector3d& direction : directions) {
    const double sine = std::abs(normal_in_world.dot(direction));
    if (sine >= least) continue;
    least = sine;
    nearest = &direction;
  }
  return nearest;
}

/// The straight edges that run as those of their sub-map do, of keyframes that may move. A part lies in one sub-map.
void AddLines(const Map& map, NamedProblem& named) {
  if (named.keyframes.empty()) return;
  const std::vector<Eigen::Vector3d> directions = DirectionsOf(map, map.Find(named.keyframes.front())->root);
  for (uint32_t row = 0; row < named.keyframes.size(); ++row) {
    const Keyframe& keyframe = *map.Find(named.keyframes[row]);
    if (named.problem.is_fixed[row] || !keyframe.lines) continue;
    const Eigen::Matrix3d world_from_cam = keyframe.cam_from_world.rotation.conjugate().toRotationMatrix();
    for (const LineSight& line : *keyframe.lines) {
      const Eigen::Vector3d normal = line.normal.cast<double>();
      const Eigen::Vector3d* direction = NearestOf(directions, world_from_cam * normal);
      if (direction) named.problem.lines.push_back({row, normal, *direction, line.sigma});
    }
  }
}

NamedProblem Collect(const Map& map, const MapBundlePart& part) {
  NamedProblem named;
  for (const KeyframeId id : part.inside) {
    const bool is_held = std::find(part.held.begin(), part.held.end(), id) != part.held.end();
    AddKeyframe(map, id, is_held, named);
  }
  for (const KeyframeId id : part.around) AddKeyframe(map, id, true, named);
  named.landmarks = map.SeenBy(part.inside);
  if (!named.keyframes.empty()) {
    named.problem.projection = Projection(*map.Find(named.keyframes.front())->frame->rig);
  }
  const RowOf row_of = RowsOf(named.keyframes);
  AddLandmarks(map, row_of, named);
  AddTies(map, row_of, named);
  AddLines(map, named);
  return named;
}

}  // namespace

MapBundle AdjustMapBundle(const Map& map, const MapBundlePart& part, const BundleOptions& options,
                          const std::function<bool()>& should_stop) {
  const NamedProblem named = Collect(map, part);
  const BundleResult result = AdjustBundle(named.problem, options, should_stop);

  MapBundle bundle;
  bundle.num_observations = named.problem.seen.size();
  bundle.initial_cost = result.initial_cost;
  bundle.final_cost = result.final_cost;
  bundle.was_stopped = result.was_stopped;
  for (size_t row = 0; row < named.keyframes.size(); ++row) {
    if (!named.problem.is_fixed[row]) bundle.poses.emplace_back(named.keyframes[row], result.poses[row]);
  }
  for (size_t row = 0; row < named.landmarks.size(); ++row) {
    bundle.points.emplace_back(named.landmarks[row], result.points[row]);
  }
  for (size_t i = 0; i < named.problem.seen.size(); ++i) {
    const auto& seen = named.problem.seen[i];
    if (result.is_outlier[i]) bundle.outliers.emplace_back(named.landmarks[seen.point], named.keyframes[seen.pose]);
  }
  return bundle;
}

}  // namespace yorb

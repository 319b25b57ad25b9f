// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/local_bundle.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "optimize/observed.h"

namespace yorb {
namespace {

/// A bundle problem and what its rows are called in the map.
struct NamedProblem {
  BundleProblem problem;
  std::vector<KeyframeId> keyframes;
  std::vector<LandmarkId> landmarks;
  size_t num_moving = 0;
};

/// The keyframes outside of `moving` that see most of the landmarks.
std::vector<KeyframeId> Surrounding(const Map& map, const std::vector<LandmarkId>& landmarks,
                                    const std::vector<KeyframeId>& moving, size_t max_fixed) {
  std::map<KeyframeId, int> counts;
  for (const LandmarkId id : landmarks) {
    for (const LandmarkView& view : map.Find(id)->views) ++counts[view.keyframe];
  }
  for (const KeyframeId id : moving) counts.erase(id);
  std::vector<Neighbour> order;
  for (const auto& [id, count] : counts) order.push_back({id, count});
  std::stable_sort(order.begin(), order.end(),
                   [](const Neighbour& a, const Neighbour& b) { return a.weight > b.weight; });
  std::vector<KeyframeId> ids;
  for (size_t i = 0; i < std::min(max_fixed, order.size()); ++i) ids.push_back(order[i].id);
  return ids;
}

NamedProblem Collect(const Map& map, KeyframeId center, const LocalBundleOptions& options) {
  NamedProblem named;
  std::vector<KeyframeId> moving = {center};
  for (const KeyframeId id : map.Find(center)->Strongest(options.max_moving - 1, options.min_shared))
    moving.push_back(id);
  named.landmarks = map.SeenBy(moving);
  const std::vector<KeyframeId> fixed = Surrounding(map, named.landmarks, moving, options.max_fixed);

  // The first keyframe defines the world; where nothing else is fixed, the oldest of the neighbourhood holds it.
  const KeyframeId anchor = *std::min_element(moving.begin(), moving.end());
  BundleProblem& problem = named.problem;
  problem.projection = Projection(*map.Find(center)->frame->rig);
  std::unordered_map<KeyframeId, uint32_t> row_of;
  const auto add = [&](KeyframeId id, bool is_fixed) {
    row_of[id] = static_cast<uint32_t>(named.keyframes.size());
    named.keyframes.push_back(id);
    problem.poses.push_back(map.Find(id)->cam_from_world);
    problem.is_fixed.push_back(is_fixed);
  };
  for (const KeyframeId id : moving) {
    const bool is_first = !map.Find(id)->parent.IsValid();
    add(id, is_first || (fixed.empty() && id == anchor));
  }
  named.num_moving = named.keyframes.size();
  for (const KeyframeId id : fixed) add(id, true);

  for (uint32_t row = 0; row < named.landmarks.size(); ++row) {
    const Landmark& landmark = *map.Find(named.landmarks[row]);
    problem.points.push_back(landmark.position);
    for (const LandmarkView& view : landmark.views) {
      const auto pose = row_of.find(view.keyframe);
      if (pose == row_of.end()) continue;
      problem.seen.push_back({pose->second, row, Observed(*map.Find(view.keyframe)->frame, view.index)});
    }
  }
  return named;
}

}  // namespace

LocalBundle AdjustLocally(const Map& map, KeyframeId center, const LocalBundleOptions& options,
                          const std::function<bool()>& should_stop) {
  const NamedProblem named = Collect(map, center, options);
  const BundleResult result = AdjustBundle(named.problem, BundleOptions(), should_stop);

  LocalBundle bundle;
  bundle.num_observations = named.problem.seen.size();
  bundle.initial_cost = result.initial_cost;
  bundle.final_cost = result.final_cost;
  bundle.was_stopped = result.was_stopped;
  for (size_t row = 0; row < named.num_moving; ++row) {
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

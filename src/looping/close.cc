// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looping/close.h"

#include <algorithm>
#include <unordered_map>

#include "optimize/pose_graph.h"

namespace yorb {
namespace {

/// A pose graph whose rows are keyframes.
struct NamedGraph {
  std::vector<KeyframeId> keyframes;
  std::unordered_map<KeyframeId, uint32_t> row_of;
  PoseGraph graph;
};

void AddEdge(NamedGraph& named, KeyframeId from, KeyframeId to, const Rigid3& to_from_from, double weight) {
  named.graph.edges.push_back({named.row_of.at(from), named.row_of.at(to), to_from_from, weight});
}

/// The more landmarks tie two keyframes, the less they give way to each other: the drift is where they are few.
double WeightOf(int num_shared) {
  constexpr double kOne = 100, kMost = 4, kLeast = 0.05;
  return std::clamp(num_shared / kOne, kLeast, kMost);
}

/// The keyframes of a sub-map, tied together as they lie now.
NamedGraph GraphOf(const Map& map, KeyframeId root) {
  constexpr int kStrong = 100;  // landmarks in common
  NamedGraph named;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (keyframe.root != root) return;
    named.row_of[keyframe.id] = static_cast<uint32_t>(named.keyframes.size());
    named.keyframes.push_back(keyframe.id);
    named.graph.poses.push_back(keyframe.cam_from_world);
    named.graph.is_fixed.push_back(keyframe.id == root);
  });
  for (const KeyframeId id : named.keyframes) {
    const Keyframe& keyframe = *map.Find(id);
    const auto tie = [&](KeyframeId other) {
      const Rigid3 id_from_other = keyframe.cam_from_world * map.Find(other)->cam_from_world.Inverse();
      AddEdge(named, other, id, id_from_other, WeightOf(keyframe.NumShared(other)));
    };
    if (keyframe.parent.IsValid()) tie(keyframe.parent);
    for (const Neighbour& neighbour : keyframe.neighbours) {
      const bool is_in_tree = neighbour.id == keyframe.parent || map.Find(neighbour.id)->parent == id;
      if (neighbour.id < id && neighbour.weight >= kStrong && !is_in_tree) tie(neighbour.id);
    }
    for (const KeyframeId loop : keyframe.loops) {
      if (loop < id) tie(loop);
    }
  }
  return named;
}

Correction CloseWithin(const Map& map, const Recognition& recognition) {
  NamedGraph named = GraphOf(map, map.Find(recognition.newer)->root);
  const Rigid3 newer_from_older = recognition.cam_from_world * map.Find(recognition.older)->cam_from_world.Inverse();
  const double weight = WeightOf(static_cast<int>(recognition.num_inliers));
  AddEdge(named, recognition.older, recognition.newer, newer_from_older, weight);
  const PoseGraphResult result = AdjustPoseGraph(named.graph);
  Correction correction;
  for (size_t row = 0; row < named.keyframes.size(); ++row) {
    correction.poses.emplace_back(named.keyframes[row], result.poses[row]);
  }
  return correction;
}

Correction CloseBetween(const Map& map, const Recognition& recognition) {
  const Keyframe& newer = *map.Find(recognition.newer);
  const KeyframeId older_root = map.Find(recognition.older)->root;
  const Rigid3 newers_from_olders = newer.cam_from_world.Inverse() * recognition.cam_from_world;
  const bool newers_moves = older_root < newer.root;
  const Rigid3 before_from_after = newers_moves ? newers_from_olders : newers_from_olders.Inverse();
  const KeyframeId moving = newers_moves ? newer.root : older_root;
  Correction correction;
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (keyframe.root == moving)
      correction.poses.emplace_back(keyframe.id, keyframe.cam_from_world * before_from_after);
  });
  return correction;
}

}  // namespace

Correction Close(const Map& map, const Recognition& recognition) {
  const bool is_loop = map.Find(recognition.newer)->root == map.Find(recognition.older)->root;
  Correction correction = is_loop ? CloseWithin(map, recognition) : CloseBetween(map, recognition);
  correction.place = SamePlace{recognition.newer, recognition.older};
  return correction;
}

}  // namespace yorb

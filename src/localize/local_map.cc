// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize/local_map.h"

#include <algorithm>

namespace yorb {
namespace {

/// A set of ids that remembers nothing between uses: one bit an id, the ids being dense.
template <typename Kind>
class IdSet {
 public:
  /// True where the id was not in it before.
  bool Insert(Id<Kind> id) {
    if (id.value() >= bits_.size()) bits_.resize(id.value() + 1024, false);
    if (bits_[id.value()]) return false;
    bits_[id.value()] = true;
    return true;
  }

 private:
  std::vector<bool> bits_;
};

/// How many of the matched landmarks each keyframe sees, the most first.
std::vector<Neighbour> CountVotes(const Map& map, const std::vector<LandmarkId>& matches) {
  std::vector<KeyframeId> votes;
  for (const LandmarkId id : matches) {
    const Landmark* landmark = map.Find(id);
    if (!landmark) continue;
    for (const LandmarkView& view : landmark->views) votes.push_back(view.keyframe);
  }
  std::sort(votes.begin(), votes.end());
  std::vector<Neighbour> counts;
  for (const KeyframeId vote : votes) {
    if (counts.empty() || counts.back().id != vote) counts.push_back({vote, 0});
    ++counts.back().weight;
  }
  std::stable_sort(counts.begin(), counts.end(),
                   [](const Neighbour& a, const Neighbour& b) { return a.weight > b.weight; });
  return counts;
}

}  // namespace

LocalMap CollectLocalMap(const Map& map, const std::vector<LandmarkId>& matches, size_t max_keyframes) {
  constexpr size_t kNeighboursOfEach = 10;
  constexpr int kMinShared = 15;
  LocalMap local;
  IdSet<Keyframe> in_it;
  const auto add = [&](KeyframeId id) {
    if (id.IsValid() && local.keyframes.size() < max_keyframes && in_it.Insert(id)) local.keyframes.push_back(id);
  };
  for (const Neighbour& vote : CountVotes(map, matches)) add(vote.id);
  if (local.keyframes.empty()) return local;
  local.reference = local.keyframes.front();
  const size_t num_direct = local.keyframes.size();
  for (size_t i = 0; i < num_direct && local.keyframes.size() < max_keyframes; ++i) {
    const Keyframe& keyframe = *map.Find(local.keyframes[i]);
    for (const KeyframeId id : keyframe.Strongest(kNeighboursOfEach, kMinShared)) add(id);
    for (const KeyframeId id : keyframe.children) add(id);
    add(keyframe.parent);
  }
  return local;
}

std::vector<ExpectedLandmark> ExpectLocalLandmarks(const Map& map, const LocalMap& local, const Frame& frame,
                                                   const Rigid3& cam_from_world, const std::vector<LandmarkId>& matches,
                                                   float widening) {
  IdSet<Landmark> seen;
  for (const LandmarkId id : matches) {
    if (id.IsValid()) seen.Insert(id);
  }
  std::vector<ExpectedLandmark> expected;
  for (const KeyframeId keyframe : local.keyframes) {
    for (const LandmarkId id : map.Find(keyframe)->landmarks) {
      if (!id.IsValid() || !seen.Insert(id)) continue;
      const Landmark* landmark = map.Find(id);
      const auto area = ExpectLandmark(*landmark, frame, cam_from_world, widening);
      if (area) expected.push_back({id, landmark, *area});
    }
  }
  return expected;
}

Fix FixWithExpected(const Frame& frame, const Map& map, const Fix& coarse,
                    const std::vector<ExpectedLandmark>& expected, Support support) {
  std::vector<bool> taken(frame.size());
  for (size_t i = 0; i < frame.size(); ++i) taken[i] = coarse.matches[i].IsValid();
  const std::vector<int> rows = MatchExpected(frame, expected, taken);
  std::vector<LandmarkId> matches = coarse.matches;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] >= 0) matches[i] = expected[static_cast<size_t>(rows[i])].id;
  }
  support.followed = coarse.followed;
  return FixFromLandmarks(frame, map, coarse.cam_from_world, matches, coarse.by_depth, support);
}

}  // namespace yorb

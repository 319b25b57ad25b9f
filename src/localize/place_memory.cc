// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "localize/place_memory.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace yorb {

void PlaceMemory::Follow(const Map& map) {
  if (!CanRecall()) return;
  for (const KeyframeId id : known_) {
    if (!map.Find(id)) index_.Remove(id.value());
  }
  known_.clear();
  map.VisitKeyframes([&](const Keyframe& keyframe) {
    if (!keyframe.bag) return;
    known_.push_back(keyframe.id);
    if (!index_.Contains(keyframe.id.value())) index_.Add(keyframe.id.value(), keyframe.bag);
  });
}

Bag PlaceMemory::Describe(const Frame& frame) const {
  std::vector<Descriptor> descriptors = frame.descriptors;
  descriptors.resize(frame.size() - frame.num_suspects);
  return vocabulary_->Describe(descriptors);
}

std::vector<KeyframeId> PlaceMemory::Recall(const Map& map, const Bag& bag, size_t max_count,
                                            const std::function<bool(KeyframeId)>& may_be) const {
  constexpr size_t kMostCandidates = 30, kNeighbours = 10;
  constexpr int kOfOnePlace = 2;  // the most similar one is not always the one from which a pose is found
  std::vector<std::pair<KeyframeId, double>> candidates;  // the most similar first
  for (const Recalled& recalled : index_.Query(bag, std::numeric_limits<size_t>::max())) {
    const KeyframeId id(recalled.place);
    if (may_be(id)) candidates.emplace_back(id, recalled.similarity);
    if (candidates.size() == kMostCandidates) break;
  }
  const std::unordered_map<KeyframeId, double> similarity(candidates.begin(), candidates.end());
  std::vector<std::pair<KeyframeId, double>> chosen;
  std::unordered_map<KeyframeId, int> num_beside;  // more similar ones that were taken
  for (const auto& [id, own] : candidates) {
    if (num_beside[id] >= kOfOnePlace) continue;
    double sum = own;
    for (const KeyframeId neighbour : map.Find(id)->Strongest(kNeighbours, 1)) {
      const auto found = similarity.find(neighbour);
      if (found == similarity.end()) continue;
      sum += found->second;
      ++num_beside[neighbour];
    }
    chosen.emplace_back(id, sum);
  }
  std::stable_sort(chosen.begin(), chosen.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<KeyframeId> ids;
  for (size_t i = 0; i < std::min(max_count, chosen.size()); ++i) ids.push_back(chosen[i].first);
  return ids;
}

}  // namespace yorb

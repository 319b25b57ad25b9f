// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/local_bundle.h"

#include <algorithm>
#include <map>

namespace yorb {
namespace {

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

/// What keyframes inside are tied to holds them, too.
void AddOthersOfTies(const Map& map, MapBundlePart& part) {
  for (const KeyframeId id : part.inside) {
    const std::optional<Tie>& tie = map.Find(id)->tie;
    if (!tie) continue;
    const KeyframeId other = map.Surviving(tie->other);
    const auto has = [&](const std::vector<KeyframeId>& ids) {
      return std::find(ids.begin(), ids.end(), other) != ids.end();
    };
    if (!has(part.inside) && !has(part.around)) part.around.push_back(other);
  }
}

MapBundlePart Neighbourhood(const Map& map, KeyframeId center, const LocalBundleOptions& options) {
  MapBundlePart part;
  part.inside = {center};
  for (const KeyframeId id : map.Find(center)->Strongest(options.max_moving - 1, options.min_shared)) {
    part.inside.push_back(id);
  }
  part.around = Surrounding(map, map.SeenBy(part.inside), part.inside, options.max_fixed);
  AddOthersOfTies(map, part);
  // The first keyframe defines the world; where nothing else is fixed, the oldest of the neighbourhood holds it.
  for (const KeyframeId id : part.inside) {
    if (!map.Find(id)->parent.IsValid()) part.held.push_back(id);
  }
  if (part.around.empty()) part.held.push_back(*std::min_element(part.inside.begin(), part.inside.end()));
  return part;
}

}  // namespace

LocalBundle AdjustLocally(const Map& map, KeyframeId center, const LocalBundleOptions& options,
                          const std::function<bool()>& should_stop) {
  return AdjustMapBundle(map, Neighbourhood(map, center, options), BundleOptions(), should_stop);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/global_bundle.h"

#include <algorithm>

namespace yorb {
namespace {

/// The keyframe that holds the rest, of some that are sorted.
KeyframeId Holder(const Map& map, const std::vector<KeyframeId>& keyframes, KeyframeId wanted) {
  if (std::binary_search(keyframes.begin(), keyframes.end(), wanted)) return wanted;
  const auto first =
      std::find_if(keyframes.begin(), keyframes.end(), [&](KeyframeId id) { return !map.Find(id)->parent.IsValid(); });
  return first != keyframes.end() ? *first : keyframes.front();
}

}  // namespace

GlobalBundle AdjustGlobally(const Map& map, const std::vector<KeyframeId>& keyframes,
                            const GlobalBundleOptions& options, const std::function<bool()>& should_stop) {
  MapBundlePart part;
  for (const KeyframeId id : keyframes) {
    if (map.Find(id)) part.inside.push_back(id);
  }
  std::sort(part.inside.begin(), part.inside.end());
  part.inside.erase(std::unique(part.inside.begin(), part.inside.end()), part.inside.end());
  if (!part.inside.empty()) part.held = {Holder(map, part.inside, options.held)};
  return AdjustMapBundle(map, part, options.bundle, should_stop);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "map/map.h"
#include "places/place_index.h"
#include "places/vocabulary.h"

namespace yorb {

/// Recalls which places of a map look like a picture. It keeps an index of its own, which follows the map.
class PlaceMemory {
 public:
  explicit PlaceMemory(VocabularyPtr vocabulary) : vocabulary_(std::move(vocabulary)) {}

  /// Without a vocabulary it recalls nothing.
  bool CanRecall() const { return vocabulary_ != nullptr; }

  /// Takes in what is new in the map, and lets go of what is not there any more.
  void Follow(const Map& map);

  /// The words of a frame, but for those of suspects.
  Bag Describe(const Frame& frame) const;

  /// Keyframes of the places most like the bag, the best first, at most two of each; keyframes that look at one place
  /// speak for it together. `may_be` says which keyframes count; `map` is the one followed last.
  std::vector<KeyframeId> Recall(const Map& map, const Bag& bag, size_t max_count,
                                 const std::function<bool(KeyframeId)>& may_be) const;

 private:
  VocabularyPtr vocabulary_;
  PlaceIndex index_;
  std::vector<KeyframeId> known_;  // by ascending id
};

}  // namespace yorb

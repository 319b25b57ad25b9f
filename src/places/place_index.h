// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "places/bag.h"

namespace yorb {

/// A place that shares words with what was asked for.
struct Recalled {
  uint32_t place = 0;
  double similarity = 0;  ///< as Similarity gives it
  int shared_words = 0;
};

/// Known places by the words seen there (an inverted file): a query looks only at places that share a word. A place is
/// a number of the caller's, such as a keyframe's id. The answers depend on what is in it, never on the order of
/// adding.
class PlaceIndex {
 public:
  /// Adds a place, which must not be there yet.
  void Add(uint32_t place, std::shared_ptr<const Bag> bag);

  /// Takes a place out; nothing happens where it is not there.
  void Remove(uint32_t place);

  bool Contains(uint32_t place) const { return slot_of_.count(place) > 0; }
  size_t size() const { return slot_of_.size(); }

  /// The bag of a place; null where it is not there. Valid until the place is removed.
  const Bag* Find(uint32_t place) const;

  /// The places most like the bag, the best first, of equals the lower number first; at most so many.
  std::vector<Recalled> Query(const Bag& bag, size_t max_count) const;

 private:
  struct Slot {
    uint32_t place = 0;
    std::shared_ptr<const Bag> bag;  // null: free
  };
  struct Entry {
    uint32_t slot = 0;
    float weight = 0;
  };

  std::unordered_map<uint32_t, uint32_t> slot_of_;
  std::vector<Slot> slots_;
  std::vector<uint32_t> free_slots_;
  std::vector<uint32_t> list_of_;  // of each word, in lists_; most words are at no place, which is list 0
  std::vector<std::vector<Entry>> lists_{1};
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/place_index.h"

#include <algorithm>
#include <utility>

#include "core/check.h"

namespace yorb {

void PlaceIndex::Add(uint32_t place, std::shared_ptr<const Bag> bag) {
  YORB_CHECK(bag != nullptr, "a place without a bag");
  YORB_CHECK(!Contains(place), "a place added twice");
  uint32_t slot = static_cast<uint32_t>(slots_.size());
  if (free_slots_.empty()) {
    slots_.emplace_back();
  } else {
    slot = free_slots_.back();
    free_slots_.pop_back();
  }
  for (const WordWeight& entry : bag->words) {
    if (entry.word >= list_of_.size()) list_of_.resize(entry.word + size_t{1});
    uint32_t& list = list_of_[entry.word];
    if (list == 0) {
      list = static_cast<uint32_t>(lists_.size());
      lists_.emplace_back();
    }
    lists_[list].push_back({slot, entry.weight});
  }
  slots_[slot] = {place, std::move(bag)};
  slot_of_[place] = slot;
}

void PlaceIndex::Remove(uint32_t place) {
  const auto found = slot_of_.find(place);
  if (found == slot_of_.end()) return;
  const uint32_t slot = found->second;
  for (const WordWeight& word : slots_[slot].bag->words) {
    std::vector<Entry>& entries = lists_[list_of_[word.word]];
    const auto ours =
        std::find_if(entries.begin(), entries.end(), [slot](const Entry& entry) { return entry.slot == slot; });
    *ours = entries.back();
    entries.pop_back();
  }
  slots_[slot] = {};
  free_slots_.push_back(slot);
  slot_of_.erase(found);
}

const Bag* PlaceIndex::Find(uint32_t place) const {
  const auto found = slot_of_.find(place);
  return found == slot_of_.end() ? nullptr : slots_[found->second].bag.get();
}

std::vector<Recalled> PlaceIndex::Query(const Bag& bag, size_t max_count) const {
  std::vector<Recalled> by_slot(slots_.size());
  for (const WordWeight& word : bag.words) {
    if (word.word >= list_of_.size()) break;
    for (const Entry& entry : lists_[list_of_[word.word]]) {
      by_slot[entry.slot].similarity += std::min(word.weight, entry.weight);
      ++by_slot[entry.slot].shared_words;
    }
  }
  std::vector<Recalled> found;
  for (size_t slot = 0; slot < slots_.size(); ++slot) {
    if (by_slot[slot].shared_words == 0) continue;
    found.push_back(by_slot[slot]);
    found.back().place = slots_[slot].place;
  }
  const auto best = found.begin() + static_cast<std::ptrdiff_t>(std::min(max_count, found.size()));
  std::partial_sort(found.begin(), best, found.end(), [](const Recalled& a, const Recalled& b) {
    return a.similarity != b.similarity ? a.similarity > b.similarity : a.place < b.place;
  });
  found.erase(best, found.end());
  return found;
}

}  // namespace yorb

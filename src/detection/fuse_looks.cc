// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/fuse_looks.h"

#include <algorithm>
#include <cstddef>

#include "core/iou.h"

namespace yorb {
namespace {

struct SeenBox {
  Box box;
  size_t look = 0;
};

/// One thing as several looks saw it.
class FusedBox {
 public:
  FusedBox(const SeenBox& first, size_t num_looks) : mean_(first.box), by_look_(num_looks, 0) { Add(first); }

  void Add(const SeenBox& seen) {
    const double weight = seen.box.confidence, whole = weight_ + weight;
    const auto mean = [&](double so_far, double more) { return (weight_ * so_far + weight * more) / whole; };
    mean_.left = mean(mean_.left, seen.box.left), mean_.right = mean(mean_.right, seen.box.right);
    mean_.top = mean(mean_.top, seen.box.top), mean_.bottom = mean(mean_.bottom, seen.box.bottom);
    weight_ = whole;
    by_look_[seen.look] = std::max(by_look_[seen.look], weight);
  }

  double OverlapWith(const Box& other) const {
    const double overlap = IoU(mean_, other);
    return overlap > 0 && other.name == mean_.name ? overlap : 0;
  }

  Box Mean() const {
    Box box = mean_;
    box.confidence = 0;
    for (const double confidence : by_look_) box.confidence += confidence / static_cast<double>(by_look_.size());
    return box;
  }

 private:
  Box mean_;
  double weight_ = 0;
  std::vector<double> by_look_;  ///< the highest confidence of each
};

/// The thing that a box overlaps most, if it does so enough to be one with it.
FusedBox* ThingOf(const Box& box, std::vector<FusedBox>& things, double least_overlap) {
  FusedBox* nearest = nullptr;
  for (FusedBox& thing : things) {
    const double overlap = thing.OverlapWith(box);
    if (overlap > least_overlap) nearest = &thing, least_overlap = overlap;
  }
  return nearest;
}

}  // namespace

std::vector<Box> FuseLooks(const std::vector<std::vector<Box>>& looks, double least_overlap) {
  std::vector<SeenBox> all;
  for (size_t look = 0; look < looks.size(); ++look) {
    for (const Box& box : looks[look]) all.push_back({box, look});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const SeenBox& a, const SeenBox& b) { return a.box.confidence > b.box.confidence; });
  std::vector<FusedBox> things;
  for (const SeenBox& seen : all) {
    if (FusedBox* thing = ThingOf(seen.box, things, least_overlap)) {
      thing->Add(seen);
    } else {
      things.emplace_back(seen, looks.size());
    }
  }
  std::vector<Box> fused;
  for (const FusedBox& thing : things) fused.push_back(thing.Mean());
  std::stable_sort(fused.begin(), fused.end(), [](const Box& a, const Box& b) { return a.confidence > b.confidence; });
  return fused;
}

}  // namespace yorb

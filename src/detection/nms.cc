// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/nms.h"

#include <algorithm>

#include "core/iou.h"

namespace yorb {
namespace {

/// Weaker boxes than so many are not looked at: a crowd has hundreds, and the search is quadratic within a class.
constexpr size_t kMostCandidates = 8192;

}  // namespace

std::vector<RawBox> SuppressDoubles(std::vector<RawBox> boxes, double most_overlap, size_t most_boxes) {
  std::stable_sort(boxes.begin(), boxes.end(),
                   [](const RawBox& a, const RawBox& b) { return a.confidence > b.confidence; });
  if (boxes.size() > kMostCandidates) boxes.resize(kMostCandidates);
  std::vector<std::vector<RawBox>> kept_of_class;
  std::vector<RawBox> kept;
  for (const RawBox& box : boxes) {
    if (kept.size() >= most_boxes) break;
    const auto label = static_cast<size_t>(box.label);
    if (kept_of_class.size() <= label) kept_of_class.resize(label + 1);
    auto& rivals = kept_of_class[label];
    const auto covers = [&](const RawBox& rival) { return IoU(rival, box) > most_overlap; };
    if (std::any_of(rivals.begin(), rivals.end(), covers)) continue;
    rivals.push_back(box);
    kept.push_back(box);
  }
  return kept;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/nms.h"

#include <algorithm>

namespace yorb {
namespace {

/// Weaker boxes than so many are not looked at: a crowd has hundreds, and the search is quadratic within a class.
constexpr size_t kMostCandidates = 8192;

}  // namespace

double Overlap(const RawBox& a, const RawBox& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  if (!(width > 0) || !(height > 0)) return 0;
  const double shared = width * height;
  const double area_a = static_cast<double>(a.right - a.left) * (a.bottom - a.top);
  const double area_b = static_cast<double>(b.right - b.left) * (b.bottom - b.top);
  return shared / (area_a + area_b - shared);
}

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
    const auto covers = [&](const RawBox& rival) { return Overlap(rival, box) > most_overlap; };
    if (std::any_of(rivals.begin(), rivals.end(), covers)) continue;
    rivals.push_back(box);
    kept.push_back(box);
  }
  return kept;
}

}  // namespace yorb

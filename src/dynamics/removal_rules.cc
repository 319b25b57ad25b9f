// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/removal_rules.h"

#include <algorithm>

#include "dynamics/depth_cells.h"

namespace yorb {
namespace {

/// Pixels are squares around whole coordinates; a box holds the pixels whose centres it covers.
bool HoldsPixel(const Box& box, const Keypoint& point) {
  return Holds(box, static_cast<double>(point.x) + 0.5, static_cast<double>(point.y) + 0.5);
}

}  // namespace

const char* ToString(Verdict verdict) {
  switch (verdict) {
    case Verdict::kDynamic:
      return "dynamic";
    case Verdict::kGivenBack:
      return "given_back";
    default:
      return "static";
  }
}

std::vector<SortedBox> SortByMotion(const std::vector<Box>& boxes, const MotionTable& table) {
  std::vector<SortedBox> sorted;
  for (const Box& box : boxes) sorted.push_back({box, table.Of(box.name)});
  return sorted;
}

bool Touch(const Box& a, const Box& b) {
  return std::max(a.left, b.left) < std::min(a.right, b.right) && std::max(a.top, b.top) < std::min(a.bottom, b.bottom);
}

BoxRules::BoxRules(const std::vector<SortedBox>& boxes) {
  for (const SortedBox& sorted : boxes) {
    if (sorted.motion == Motion::kHigh) high_.push_back(sorted.box);
    if (sorted.motion == Motion::kStatic) still_.push_back(sorted.box);
  }
  for (const SortedBox& sorted : boxes) {
    if (sorted.motion != Motion::kLow) continue;
    const bool touches = std::any_of(high_.begin(), high_.end(), [&](const Box& h) { return Touch(h, sorted.box); });
    if (touches) carried_.push_back(sorted.box);
  }
}

Verdict BoxRules::Judge(const Keypoint& point) const {
  const auto is_in = [&](const std::vector<Box>& boxes) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return HoldsPixel(box, point); });
  };
  return (is_in(high_) && !is_in(still_)) || is_in(carried_) ? Verdict::kDynamic : Verdict::kStatic;
}

void BoxRules::Mark(cv::Mat& cells) const {
  const auto paint = [&](const std::vector<Box>& boxes, int value) {
    for (const Box& box : boxes) {
      const CellRange range = CellsOf(box, cells.cols, cells.rows);
      if (range.size() > 0) cells(cv::Range(range.top, range.bottom), cv::Range(range.left, range.right)).setTo(value);
    }
  };
  paint(high_, 1);
  paint(still_, 0);
  paint(carried_, 1);
}

}  // namespace yorb

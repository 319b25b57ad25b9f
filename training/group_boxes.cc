// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/group_boxes.h"

#include <algorithm>
#include <cmath>

namespace yorb {
namespace {

constexpr float kInside = 0.85f;  // part of a box that lies in another's, for it to belong to it
constexpr float kSmaller = 0.6f;  // of its area; two boxes of about one size are two views of one thing
constexpr int kLeastMembers = 2;

float Overlap(float a_centre, float a_length, float b_centre, float b_length) {
  const float low = std::max(a_centre - a_length / 2, b_centre - b_length / 2);
  const float high = std::min(a_centre + a_length / 2, b_centre + b_length / 2);
  return std::max(0.0f, high - low);
}

bool IsMember(const LabelBox& small, const LabelBox& group) {
  const float area = small.width * small.height;
  const float inside =
      Overlap(small.cx, small.width, group.cx, group.width) * Overlap(small.cy, small.height, group.cy, group.height);
  return small.class_index == group.class_index && inside > kInside * area &&
         area < kSmaller * group.width * group.height;
}

}  // namespace

void DoubtGroups(std::vector<LabelBox>& boxes) {
  for (LabelBox& box : boxes) {
    const auto num_members =
        std::count_if(boxes.begin(), boxes.end(), [&](const LabelBox& other) { return IsMember(other, box); });
    if (num_members >= kLeastMembers) box.is_doubtful = 1;
  }
}

}  // namespace yorb

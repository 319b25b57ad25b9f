// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/trim.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace yorb {
namespace {

/// Rows by falling response; equal ones in their old order.
std::vector<size_t> ByResponse(const std::vector<Keypoint>& keypoints) {
  std::vector<size_t> order(keypoints.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return keypoints[a].response > keypoints[b].response; });
  return order;
}

/// Puts the rows that go over the share of their part of the picture behind all others, otherwise keeping the order.
void PutCrowdedLast(const std::vector<Keypoint>& keypoints, size_t wanted, std::vector<size_t>& order) {
  constexpr int kParts = 8;  // each way
  constexpr size_t kShares = 2;
  float right = 1, bottom = 1;
  for (const Keypoint& keypoint : keypoints) {
    right = std::max(right, keypoint.x);
    bottom = std::max(bottom, keypoint.y);
  }
  const size_t most = std::max<size_t>(1, kShares * wanted / (kParts * kParts));
  std::vector<size_t> counts(kParts * kParts, 0);
  std::stable_partition(order.begin(), order.end(), [&](size_t row) {
    const int column = std::min(kParts - 1, static_cast<int>(keypoints[row].x / right * kParts));
    const int line = std::min(kParts - 1, static_cast<int>(keypoints[row].y / bottom * kParts));
    return ++counts[static_cast<size_t>(line * kParts + column)] <= most;
  });
}

}  // namespace

Features Trim(Features features, size_t wanted, TrimBy by) {
  if (features.keypoints.size() <= wanted) return features;
  std::vector<size_t> order = ByResponse(features.keypoints);
  if (by == TrimBy::kSpread) PutCrowdedLast(features.keypoints, wanted, order);
  order.resize(wanted);
  std::sort(order.begin(), order.end());
  Features kept;
  kept.keypoints.reserve(wanted);
  kept.descriptors.reserve(wanted);
  for (const size_t row : order) {
    kept.keypoints.push_back(features.keypoints[row]);
    kept.descriptors.push_back(features.descriptors[row]);
  }
  return kept;
}

}  // namespace yorb

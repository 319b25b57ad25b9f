// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/time.h"

namespace yorb {

/// Two stamps that belong together, by their places in the lists.
struct StampPair {
  size_t first = 0, second = 0;

  friend bool operator==(const StampPair& a, const StampPair& b) { return a.first == b.first && a.second == b.second; }
};

/// Pairs stamps one to one, the nearest first, strictly nearer than `max_difference_ns` (TUM's rule; of equally near
/// pairs the earlier first stamp, then the earlier second one). Both lists rise strictly. In the order of time, in
/// O(n log n) however wide the tolerance.
std::vector<StampPair> AssociateStamps(const std::vector<Timestamp>& first, const std::vector<Timestamp>& second,
                                       int64_t max_difference_ns);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/time.h"

namespace yorb {

/// Two stamps that belong together, by their places in the lists.
struct StampPair {
  size_t first = 0, second = 0;

  friend bool operator==(const StampPair& a, const StampPair& b) { return a.first == b.first && a.second == b.second; }
};

/// Seconds as TUM's scripts hold them: the nearest double. Where two stamps are equally near a third to the digit, its
/// rounding decides which is taken, and that moves the sixth digit of published figures (the RPE of fr2_desk).
double TumSeconds(Timestamp stamp);

/// Pairs stamps one to one, the nearest first, strictly nearer than `max_difference` seconds, with `offset` seconds
/// added to the second list (TUM's rule; of equally near pairs the earlier first stamp, then the earlier second one).
/// Both lists rise strictly. The pairs come in the order of time, in O(n log n) however wide the tolerance.
std::vector<StampPair> AssociateStamps(const std::vector<Timestamp>& first, const std::vector<Timestamp>& second,
                                       double max_difference, double offset = 0);

}  // namespace yorb

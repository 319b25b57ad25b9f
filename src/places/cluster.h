// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/random.h"
#include "features/keypoint.h"

namespace yorb {

/// The descriptor that has of each bit what most of `count` rows have; of a tie, 0. By sums that are kept bit by bit,
/// 256 counters at once.
Descriptor MajorityOf(const Descriptor* rows, size_t count);

/// Rows told apart into clusters.
struct Clusters {
  std::vector<Descriptor> centres;  ///< none is equal to another
  std::vector<size_t> sizes;        ///< in rows, each at least 1
};

/// How clusters are sought.
struct ClusterOptions {
  int most_clusters = 10;
  int most_rounds = 12;  ///< of assigning rows and moving centres
};

/// Tells rows apart by k-medians in Hamming distance (k-means++ chooses where to begin, centres are majorities of
/// bits), and sorts them by cluster in place, keeping their order within. Fewer clusters come out where rows are alike.
Clusters ClusterRows(Descriptor* rows, size_t count, const ClusterOptions& options, Random& random);

}  // namespace yorb

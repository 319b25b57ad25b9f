// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/time.h"

namespace yorb {

/// The six numbers that trajectory evaluations print; `std` is over n, as numpy and TUM's scripts have it.
struct Summary {
  double rmse = 0, mean = 0, median = 0, std = 0, min = 0, max = 0;
  size_t count = 0;
};

/// Sums up a sample; all zero for an empty one.
Summary Summarize(std::vector<double> values);

/// The value below which `fraction` of the sample lies, by linear interpolation between neighbours as numpy does it;
/// 0 for an empty sample.
double Quantile(std::vector<double> values, double fraction);

/// The median of the steps between neighbours in seconds; 0 for fewer than two.
double MedianStep(const std::vector<Timestamp>& times);

}  // namespace yorb

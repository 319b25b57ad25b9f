// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace yorb {

/// The part of the number line that an axis shows.
struct AxisRange {
  double low = 0, high = 1;

  double Length() const { return high - low; }
};

/// The range of the finite values (nothing finite: 0 to 1), never empty; with `margin` of its length on both sides.
AxisRange RangeOf(const std::vector<double>& values, double margin);

/// Round positions (1, 2 or 5 times a power of ten apart) inside the range, at most `max_count` of them, and
/// two at least where `max_count` is 5 or more.
std::vector<double> NiceTicks(const AxisRange& range, int max_count);

/// The labels of evenly spaced ticks: as many decimals as tell them apart, powers of ten where numbers grow long.
std::vector<std::string> TickLabels(const std::vector<double>& ticks);

}  // namespace yorb

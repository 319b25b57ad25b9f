// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/stats.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace yorb {

Summary Summarize(std::vector<double> values) {
  Summary s;
  s.count = values.size();
  if (values.empty()) return s;
  double sum = 0, sum_of_squares = 0;
  for (const double v : values) {
    sum += v;
    sum_of_squares += v * v;
  }
  const double n = static_cast<double>(values.size());
  s.mean = sum / n;
  s.rmse = std::sqrt(sum_of_squares / n);
  double spread = 0;
  for (const double v : values) spread += (v - s.mean) * (v - s.mean);
  s.std = std::sqrt(spread / n);
  s.min = *std::min_element(values.begin(), values.end());
  s.max = *std::max_element(values.begin(), values.end());
  s.median = Quantile(std::move(values), 0.5);
  return s;
}

double Quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0;
  const double position = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto index = static_cast<size_t>(position);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(index);
  std::nth_element(values.begin(), nth, values.end());
  const double low = *nth;
  if (index + 1 == values.size()) return low;
  const double high = *std::min_element(nth + 1, values.end());
  return low + (high - low) * (position - static_cast<double>(index));
}

double MedianStep(const std::vector<Timestamp>& times) {
  std::vector<double> steps;
  for (size_t i = 1; i < times.size(); ++i) steps.push_back(SecondsBetween(times[i - 1], times[i]));
  return Quantile(std::move(steps), 0.5);
}

}  // namespace yorb

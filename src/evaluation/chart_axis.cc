// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/chart_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.h"

namespace yorb {
namespace {

constexpr int kMostDecimals = 6;     // finer steps are written with a power of ten
constexpr double kLongNumber = 1e7;  // and so are numbers from here on

/// The smallest of 1, 2, 5 times a power of ten that is not below `least`.
double NiceStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

AxisRange RangeOf(const std::vector<double>& values, double margin) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) return {0, 1};
  // A length that doubles can still divide: at least a billionth of the numbers themselves.
  const double least = std::max(1e-12, 1e-9 * std::max(std::abs(low), std::abs(high)));
  if (high - low < least) {
    const double half = std::max(0.5 * least, low == 0 ? 0.5 : 0.05 * std::abs(low));
    return {low - half, high + half};
  }
  const double extra = margin * (high - low);
  return {low - extra, high + extra};
}

std::vector<double> NiceTicks(const AxisRange& range, int max_count) {
  if (!(range.Length() > 0) || !std::isfinite(range.Length())) return {};
  double step = NiceStep(range.Length() / (std::max(1, max_count) + 1));
  const auto count = [&] { return std::floor(range.high / step + 1e-9) - std::ceil(range.low / step - 1e-9) + 1; };
  while (count() > max_count) step = NiceStep(step * 1.5);
  std::vector<double> ticks;
  const double first = std::ceil(range.low / step - 1e-9);
  for (int i = 0; i < static_cast<int>(count()); ++i) {
    const double tick = (first + i) * step;
    ticks.push_back(std::abs(tick) < 1e-9 * step ? 0.0 : tick);
  }
  return ticks;
}

std::vector<std::string> TickLabels(const std::vector<double>& ticks) {
  std::vector<std::string> labels;
  if (ticks.empty()) return labels;
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : std::max(std::abs(ticks[0]), 1e-12);
  const int decimals = static_cast<int>(std::ceil(-std::log10(step) - 1e-9));  // below 0: whole tens
  const double largest = std::max(std::abs(ticks.front()), std::abs(ticks.back()));
  const bool is_plain = decimals <= kMostDecimals && largest < kLongNumber;
  const int exponent = is_plain ? 0 : static_cast<int>(std::floor(std::log10(largest) + 1e-9));
  for (const double tick : ticks) {
    if (is_plain || tick == 0) {
      labels.push_back(FormatFixed(tick, is_plain ? std::max(0, decimals) : 0));
    } else {
      labels.push_back(FormatFixed(tick * std::pow(10.0, -exponent), std::clamp(decimals + exponent, 0, 9)) + "e" +
                       std::to_string(exponent));
    }
  }
  return labels;
}

}  // namespace yorb

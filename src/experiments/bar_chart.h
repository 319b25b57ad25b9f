// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace yorb {

struct Bar {
  std::string name;
  double value = 0;  ///< not finite: no bar
  std::string text;  ///< the value in words, at the bar's end
  std::string color;
  bool is_pale = false;  ///< of others: published, not measured
};

struct BarGroup {
  std::string name;
  std::vector<Bar> bars;
};

/// Bars that lie, in groups, below one another.
struct BarChart {
  std::string title, x_label;
  bool is_logarithmic = false;  ///< decades, where values lie far apart; else from 0
  std::vector<BarGroup> groups;
};

/// As an SVG file.
std::string BarChartSvg(const BarChart& chart);

}  // namespace yorb

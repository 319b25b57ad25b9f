// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/chart_axis.h"

namespace yorb {

/// One line, or one cloud of dots, of a chart. A value that is not finite lifts the pen.
struct ChartSeries {
  std::string name;  ///< for the legend; empty: not listed
  std::vector<double> x, y;
  std::string color;     ///< empty: the palette's next
  bool is_dots = false;  ///< dots in place of a line
  bool is_dashed = false;
  double width_px = 1.6;  ///< of the line, or of the dots
};

/// A stretch of the x axis in a colour of its own, behind the lines: when the camera was lost, say.
struct ChartBand {
  double from = 0, to = 0;
  std::string color, name;  ///< the legend lists each name once
};

/// A chart of lines over two axes; with bands alone it is a time line without a y axis.
struct Chart {
  std::string title, x_label, y_label;
  std::vector<ChartSeries> series;
  std::vector<ChartBand> bands;
  bool is_equal_aspect = false;      ///< one metre is as long on both axes: maps, views from above
  bool is_from_zero = false;         ///< the y axis begins at 0: errors, times, counts
  std::optional<AxisRange> x_range;  ///< where several charts share their x axis; else what is there
  int width_px = 860, height_px = 340;
};

/// Colours that stay apart for the colour-blind (Okabe and Ito), in the order of use.
const std::vector<std::string>& ChartPalette();

/// The grey in which the truth is drawn.
extern const char* const kChartReferenceColor;

/// The chart as an SVG file. Long series are thinned to what can be seen; numbers are the same in every locale.
std::string ChartSvg(const Chart& chart);

/// Several charts under one title in one SVG file, row by row, each row's charts side by side.
std::string ChartSheetSvg(const std::string& title, const std::vector<std::vector<Chart>>& rows);

/// `x`, `y` as a series that breaks where the step of `time` is over `gap`: nothing is drawn where nothing was known.
ChartSeries SeriesWithGaps(const std::string& name, const std::vector<double>& time, double gap,
                           const std::vector<double>& x, const std::vector<double>& y);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/bar_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.h"
#include "evaluation/chart_axis.h"
#include "evaluation/svg.h"

namespace yorb {
namespace {

constexpr double kLeft_px = 250, kPlot_px = 560, kRight_px = 230, kTop_px = 64, kBottom_px = 60;
constexpr double kBar_px = 15, kBarStep_px = 20, kGroupHead_px = 26, kGroupGap_px = 14;
const char* const kInk = "class=\"ink\" fill=\"#1d2330\" font-size=\"13\"";
const char* const kFaint = "class=\"faint\" fill=\"#5b6270\" font-size=\"12\"";
const char* const kGrid = "class=\"grid\" stroke=\"#d9dde4\" stroke-width=\"1\"";

/// From values to pixels, and where the axis has its marks.
struct BarAxis {
  bool is_logarithmic = false;
  AxisRange range;  ///< of powers of ten where it is logarithmic
  std::vector<double> ticks;
  std::vector<std::string> labels;

  double At(double value) const {
    const double place = is_logarithmic ? std::log10(value) : value;
    return kLeft_px + kPlot_px * std::clamp((place - range.low) / range.Length(), 0.0, 1.0);
  }
};

BarAxis DecadeAxis(double least, double most) {
  BarAxis axis;
  axis.is_logarithmic = true;
  // Not too near the least value: its bar, too, must be seen.
  axis.range = {std::floor(std::log10(least) - 0.2), std::ceil(std::log10(most))};
  for (double power = axis.range.low; power <= axis.range.high; ++power) {
    axis.ticks.push_back(std::pow(10.0, power));
    axis.labels.push_back(FormatShortest(axis.ticks.back()));
  }
  return axis;
}

BarAxis AxisOf(const BarChart& chart) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const BarGroup& group : chart.groups) {
    for (const Bar& bar : group.bars) {
      if (!std::isfinite(bar.value) || bar.value <= 0) continue;
      least = std::min(least, bar.value);
      most = std::max(most, bar.value);
    }
  }
  if (chart.is_logarithmic && most > 0) return DecadeAxis(least, most);
  BarAxis axis;
  axis.range = {0, most > 0 ? 1.05 * most : 1};
  axis.ticks = NiceTicks(axis.range, 8);
  axis.labels = TickLabels(axis.ticks);
  return axis;
}

void DrawBar(SvgCanvas& canvas, const BarAxis& axis, const Bar& bar, double y) {
  canvas.Text({kLeft_px - 10, y + 12}, bar.name, SvgAnchor::kEnd, kInk);
  double end = kLeft_px;
  if (std::isfinite(bar.value) && bar.value > 0) {
    end = axis.At(bar.value);
    canvas.Rect({kLeft_px, y}, std::max(1.0, end - kLeft_px), kBar_px,
                "fill=\"" + bar.color + "\"" + (bar.is_pale ? " fill-opacity=\"0.45\"" : ""));
  }
  canvas.Text({end + 8, y + 12}, bar.text, SvgAnchor::kStart, kFaint);
}

double HeightOf(const BarChart& chart) {
  double height = 0;
  for (const BarGroup& group : chart.groups) {
    height += kGroupHead_px + kBarStep_px * static_cast<double>(group.bars.size()) + kGroupGap_px;
  }
  return height;
}

}  // namespace

std::string BarChartSvg(const BarChart& chart) {
  const BarAxis axis = AxisOf(chart);
  const double bottom = kTop_px + HeightOf(chart), width = kLeft_px + kPlot_px + kRight_px;
  SvgCanvas canvas;
  canvas.Rect({0, 0}, width, bottom + kBottom_px, "class=\"paper\" fill=\"#ffffff\"");
  canvas.Text({20, 32}, chart.title, SvgAnchor::kStart,
              "class=\"ink\" fill=\"#1d2330\" font-size=\"19\" font-weight=\"600\"");
  for (size_t k = 0; k < axis.ticks.size(); ++k) {
    const double x = axis.At(axis.ticks[k]);
    canvas.Line({x, kTop_px}, {x, bottom}, kGrid);
    canvas.Text({x, bottom + 18}, axis.labels[k], SvgAnchor::kMiddle, kFaint);
  }
  canvas.Text({kLeft_px + kPlot_px / 2, bottom + 42}, chart.x_label, SvgAnchor::kMiddle, kFaint);
  double y = kTop_px;
  for (const BarGroup& group : chart.groups) {
    canvas.Text({20, y + 17}, group.name, SvgAnchor::kStart, std::string(kInk) + " font-weight=\"600\"");
    y += kGroupHead_px;
    for (const Bar& bar : group.bars) {
      DrawBar(canvas, axis, bar, y);
      y += kBarStep_px;
    }
    y += kGroupGap_px;
  }
  return canvas.Document(width, bottom + kBottom_px);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluation/chart_axis.h"
#include "evaluation/chart_thin.h"
#include "evaluation/svg.h"

namespace yorb {

const char* const kChartReferenceColor = "#8a8f98";

namespace {

constexpr double kCharacter_px = 6.0;  // mean width of a letter at the size of labels
constexpr double kLeft_px = 80, kTop_px = 40, kBottom_px = 46, kRight_px = 18;
constexpr double kLegendRow_px = 18, kSample_px = 25, kEntryGap_px = 18, kTitleLetter_px = 8.5;
constexpr double kTickEvery_x_px = 85, kTickEvery_y_px = 27;
const char* const kInk = "class=\"ink\" fill=\"#1f2430\"";
const char* const kFaintInk = "class=\"faint\" fill=\"#5b6270\" font-size=\"12\"";
const char* const kGrid = "class=\"grid\" stroke=\"#e3e6eb\" stroke-width=\"1\"";
const char* const kFrame = "class=\"frame\" stroke=\"#9aa1ad\" stroke-width=\"1\"";

/// How many letters a UTF-8 text shows.
double Letters(const std::string& text) {
  return static_cast<double>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string ColorOf(const Chart& chart, size_t index) {
  if (!chart.series[index].color.empty()) return chart.series[index].color;
  return ChartPalette()[index % ChartPalette().size()];
}

std::string StrokeOf(const ChartSeries& series, const std::string& color) {
  return "fill=\"none\" stroke=\"" + color + "\" stroke-width=\"" + SvgNumber(series.width_px) +
         "\" stroke-linejoin=\"round\" stroke-linecap=\"round\"" +
         (series.is_dashed ? " stroke-dasharray=\"5 4\"" : "");
}

/// What the legend says of one series or one kind of band.
struct LegendEntry {
  std::string name, color;
  enum class Sample { kLine, kDot, kBox } sample = Sample::kLine;
  std::string stroke;

  double Width() const { return kSample_px + kCharacter_px * Letters(name) + kEntryGap_px; }
};

std::vector<LegendEntry> Legend(const Chart& chart) {
  std::vector<LegendEntry> entries;
  for (size_t i = 0; i < chart.series.size(); ++i) {
    const ChartSeries& series = chart.series[i];
    const std::string color = ColorOf(chart, i);
    const auto sample = series.is_dots ? LegendEntry::Sample::kDot : LegendEntry::Sample::kLine;
    if (!series.name.empty()) entries.push_back({series.name, color, sample, StrokeOf(series, color)});
  }
  for (const ChartBand& band : chart.bands) {
    const auto is_same = [&](const LegendEntry& entry) { return entry.name == band.name; };
    if (band.name.empty() || std::any_of(entries.begin(), entries.end(), is_same)) continue;
    entries.push_back({band.name, band.color, LegendEntry::Sample::kBox, ""});
  }
  return entries;
}

/// The legend in rows from the top right, the first beside the title.
std::vector<std::vector<LegendEntry>> LegendRows(const Chart& chart) {
  const double whole = chart.width_px - kLeft_px - kRight_px;
  std::vector<std::vector<LegendEntry>> rows(1);
  double room = whole - kTitleLetter_px * Letters(chart.title);
  for (const LegendEntry& entry : Legend(chart)) {
    if (entry.Width() > room && (!rows.back().empty() || rows.size() == 1)) {
      rows.emplace_back();
      room = whole;
    }
    room -= entry.Width();
    rows.back().push_back(entry);
  }
  return rows;
}

/// Where the two axes lie on the drawing.
struct Plot {
  double left = 0, top = 0, width = 1, height = 1;
  AxisRange x, y;
  std::vector<double> x_ticks, y_ticks;

  SvgPoint At(double at_x, double at_y) const {
    return {left + (at_x - x.low) / x.Length() * width, top + (y.high - at_y) / y.Length() * height};
  }
};

AxisRange RangeOfAll(const Chart& chart, std::vector<double> ChartSeries::*values, double margin) {
  std::vector<double> all;
  for (const ChartSeries& series : chart.series) {
    all.insert(all.end(), (series.*values).begin(), (series.*values).end());
  }
  if (values == &ChartSeries::x) {
    for (const ChartBand& band : chart.bands) all.insert(all.end(), {band.from, band.to});
  }
  return RangeOf(all, margin);
}

void Widen(AxisRange& range, double length) {
  const double middle = 0.5 * (range.low + range.high);
  range = {middle - 0.5 * length, middle + 0.5 * length};
}

Plot LayOut(const Chart& chart) {
  Plot plot;
  plot.top = kTop_px + kLegendRow_px * static_cast<double>(LegendRows(chart).size() - 1);
  plot.height = std::max(1.0, chart.height_px - plot.top - kBottom_px);
  plot.x = RangeOfAll(chart, &ChartSeries::x, chart.is_equal_aspect ? 0.05 : 0.0);
  if (chart.x_range) plot.x = *chart.x_range;
  plot.y = RangeOfAll(chart, &ChartSeries::y, 0.06);
  if (chart.is_from_zero) plot.y.low = std::min(0.0, plot.y.low);
  if (chart.is_from_zero && plot.y.high <= plot.y.low) plot.y.high = plot.y.low + 1;
  const double wide = chart.width_px - kLeft_px - kRight_px;
  if (chart.is_equal_aspect) {
    const double metres_a_px = std::max(plot.x.Length() / wide, plot.y.Length() / plot.height);
    Widen(plot.x, metres_a_px * wide);
    Widen(plot.y, metres_a_px * plot.height);
  }
  const double every_px = chart.is_equal_aspect ? kTickEvery_x_px : kTickEvery_y_px;
  if (!chart.series.empty()) plot.y_ticks = NiceTicks(plot.y, std::max(5, static_cast<int>(plot.height / every_px)));
  plot.left = kLeft_px;
  plot.width = wide;
  plot.x_ticks = NiceTicks(plot.x, std::max(2, static_cast<int>(plot.width / kTickEvery_x_px)));
  return plot;
}

void DrawAxes(const Chart& chart, const Plot& plot, SvgCanvas& canvas) {
  const std::vector<std::string> x_labels = TickLabels(plot.x_ticks), y_labels = TickLabels(plot.y_ticks);
  const double bottom = plot.top + plot.height, right = plot.left + plot.width;
  for (size_t i = 0; i < plot.x_ticks.size(); ++i) {
    const double x = plot.At(plot.x_ticks[i], plot.y.low).x;
    canvas.Line({x, plot.top}, {x, bottom}, kGrid);
    canvas.Text({x, bottom + 17}, x_labels[i], SvgAnchor::kMiddle, kFaintInk);
  }
  for (size_t i = 0; i < plot.y_ticks.size(); ++i) {
    const double y = plot.At(plot.x.low, plot.y_ticks[i]).y;
    canvas.Line({plot.left, y}, {right, y}, kGrid);
    canvas.Text({plot.left - 7, y + 4}, y_labels[i], SvgAnchor::kEnd, kFaintInk);
  }
  canvas.Line({plot.left, bottom}, {right, bottom}, kFrame);
  canvas.Line({plot.left, plot.top}, {plot.left, bottom}, kFrame);
  canvas.Text({0.5 * (plot.left + right), bottom + 37}, chart.x_label, SvgAnchor::kMiddle, kFaintInk);
  const SvgPoint side{16, plot.top + 0.5 * plot.height};
  canvas.Text(
      side, chart.y_label, SvgAnchor::kMiddle,
      std::string(kFaintInk) + " transform=\"rotate(-90 " + SvgNumber(side.x) + ' ' + SvgNumber(side.y) + ")\"");
}

/// The stretches between lifts of the pen, in pixels.
std::vector<std::vector<SvgPoint>> Strokes(const ChartSeries& series, const Plot& plot) {
  std::vector<std::vector<SvgPoint>> strokes(1);
  for (size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) {
      strokes.back().push_back(plot.At(series.x[i], series.y[i]));
    } else if (!strokes.back().empty()) {
      strokes.emplace_back();
    }
  }
  if (strokes.back().empty()) strokes.pop_back();
  return strokes;
}

void DrawSeries(const ChartSeries& series, const std::string& color, const Plot& plot, SvgCanvas& canvas) {
  const auto strokes = Strokes(series, plot);
  if (series.is_dots) {
    std::vector<SvgPoint> dots;
    for (const auto& stroke : strokes) dots.insert(dots.end(), stroke.begin(), stroke.end());
    for (const SvgPoint& dot : ThinDots(dots)) canvas.Circle(dot, 0.5 * series.width_px, "fill=\"" + color + '"');
    return;
  }
  for (const auto& stroke : strokes) {
    if (stroke.size() == 1) {
      canvas.Circle(stroke.front(), 0.6 * series.width_px, "fill=\"" + color + '"');
    } else {
      canvas.Polyline(ThinLine(stroke), StrokeOf(series, color));
    }
  }
}

void DrawEntry(const LegendEntry& entry, SvgPoint at, SvgCanvas& canvas) {
  const std::string fill = "fill=\"" + entry.color + '"';
  switch (entry.sample) {
    case LegendEntry::Sample::kDot:
      canvas.Circle({at.x + 13, at.y}, 3, fill);
      break;
    case LegendEntry::Sample::kLine:
      canvas.Line({at.x, at.y}, {at.x + 20, at.y}, entry.stroke);
      break;
    case LegendEntry::Sample::kBox:
      canvas.Rect({at.x + 6, at.y - 6}, 12, 12, fill);
      break;
  }
  canvas.Text({at.x + kSample_px, at.y + 4}, entry.name, SvgAnchor::kStart, kFaintInk);
}

void DrawLegend(const Chart& chart, const Plot& plot, SvgCanvas& canvas) {
  double y = kTop_px - 18;
  for (const std::vector<LegendEntry>& row : LegendRows(chart)) {
    double x = plot.left + plot.width + kEntryGap_px;
    for (const LegendEntry& entry : row) x -= entry.Width();
    for (const LegendEntry& entry : row) {
      DrawEntry(entry, {x, y}, canvas);
      x += entry.Width();
    }
    y += kLegendRow_px;
  }
}

void DrawBands(const Chart& chart, const Plot& plot, SvgCanvas& canvas) {
  constexpr double kLeast_px = 1;  // a single lost frame of an hour must show
  const std::string opacity = chart.series.empty() ? "" : " fill-opacity=\"0.18\"";
  for (const ChartBand& band : chart.bands) {
    const SvgPoint from = plot.At(band.from, plot.y.high), to = plot.At(band.to, plot.y.low);
    const double width = std::max(kLeast_px, to.x - from.x);
    canvas.Rect(from, width, to.y - from.y, "fill=\"" + band.color + '"' + opacity);
  }
}

void DrawChart(const Chart& chart, SvgCanvas& canvas) {
  const Plot plot = LayOut(chart);
  canvas.Text({plot.left, kTop_px - 14}, chart.title, SvgAnchor::kStart,
              std::string(kInk) + " font-size=\"15\" font-weight=\"600\"");
  DrawBands(chart, plot, canvas);
  DrawAxes(chart, plot, canvas);
  for (size_t i = 0; i < chart.series.size(); ++i) DrawSeries(chart.series[i], ColorOf(chart, i), plot, canvas);
  DrawLegend(chart, plot, canvas);
}

void DrawPaper(double width, double height, SvgCanvas& canvas) {
  canvas.Rect({0, 0}, width, height, "class=\"paper\" fill=\"#ffffff\"");
}

}  // namespace

const std::vector<std::string>& ChartPalette() {
  static const std::vector<std::string> kPalette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                    "#e69f00", "#56b4e9", "#6b4c9a"};
  return kPalette;
}

std::string ChartSvg(const Chart& chart) {
  SvgCanvas canvas;
  DrawPaper(chart.width_px, chart.height_px, canvas);
  DrawChart(chart, canvas);
  return canvas.Document(chart.width_px, chart.height_px);
}

std::string ChartSheetSvg(const std::string& title, const std::vector<std::vector<Chart>>& rows) {
  constexpr double kTitle_px = 44;
  SvgCanvas charts;
  double width = 0, y = title.empty() ? 0 : kTitle_px;
  for (const std::vector<Chart>& row : rows) {
    double x = 0, height = 0;
    for (const Chart& chart : row) {
      charts.Raw("<g transform=\"translate(" + SvgNumber(x) + ' ' + SvgNumber(y) + ")\">\n");
      DrawChart(chart, charts);
      charts.Raw("</g>\n");
      x += chart.width_px;
      height = std::max(height, static_cast<double>(chart.height_px));
    }
    width = std::max(width, x);
    y += height;
  }
  SvgCanvas sheet;
  DrawPaper(width, y, sheet);
  if (!title.empty())
    sheet.Text({kLeft_px, 32}, title, SvgAnchor::kStart, std::string(kInk) + " font-size=\"19\" font-weight=\"600\"");
  sheet.Raw(charts.body());
  return sheet.Document(width, y);
}

ChartSeries SeriesWithGaps(const std::string& name, const std::vector<double>& time, double gap,
                           const std::vector<double>& x, const std::vector<double>& y) {
  ChartSeries series;
  series.name = name;
  for (size_t i = 0; i < time.size(); ++i) {
    if (i > 0 && time[i] - time[i - 1] > gap) {
      series.x.push_back(std::numeric_limits<double>::quiet_NaN());
      series.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    series.x.push_back(x[i]);
    series.y.push_back(y[i]);
  }
  return series;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/report.h"

#include <algorithm>
#include <limits>

#include "core/text.h"
#include "evaluation/ate.h"
#include "evaluation/report_page.h"
#include "evaluation/rpe.h"
#include "evaluation/svg.h"
#include "evaluation/trajectory_charts.h"

namespace yorb {
namespace {

constexpr double kMaxDifference = 0.02;    // seconds
constexpr int64_t kMargin_ns = 500000000;  // of the reference around the run

/// The state words and how they are shown; any other word is shown in the last colour.
struct StateColor {
  const char* state;
  const char* name;
  const char* color;
};
constexpr StateColor kStates[] = {{"tracking", "tracking", "#009e73"},
                                  {"recently_lost", "recently lost", "#e69f00"},
                                  {"lost", "lost", "#d55e00"},
                                  {"not_initialized", "not initialised", "#9aa1ad"},
                                  {"", "", "#cc79a7"}};

const StateColor& ColorOfState(const std::string& state) {
  const auto* const found =
      std::find_if(std::begin(kStates), std::end(kStates) - 1, [&](const StateColor& s) { return state == s.state; });
  return *found;
}

std::string Percent(double share) { return FormatFixed(100 * share, 1) + " %"; }

std::string Length(double metres) {
  return metres < 0.1 ? FormatFixed(1e3 * metres, 1) + " mm" : FormatFixed(metres, 3) + " m";
}

/// The estimate brought to the reference, and what remains between them.
struct Comparison {
  TrajectoryChartInput charts;
  NamedErrors errors;
  std::optional<Summary> ate;
  RelativeError rpe;
};

Trajectory Aligned(const Alignment& alignment, const Trajectory& trajectory) {
  Trajectory aligned = trajectory;
  for (StampedPose& pose : aligned) pose.world_from_cam = alignment * pose.world_from_cam;
  return aligned;
}

/// The part of the reference while the run lasted.
Trajectory ReferenceDuring(const RunReport& report) {
  if (report.frames.empty() && report.trajectory.empty()) return report.reference;
  Timestamp first{std::numeric_limits<int64_t>::max()}, last{std::numeric_limits<int64_t>::min()};
  const auto widen = [&](Timestamp stamp) { first = std::min(first, stamp), last = std::max(last, stamp); };
  for (const ReportFrame& frame : report.frames) widen(frame.timestamp);
  for (const StampedPose& pose : report.trajectory) widen(pose.timestamp);
  Trajectory part;
  for (const StampedPose& pose : report.reference) {
    const int64_t ns = pose.timestamp.ns;
    if (ns >= first.ns - kMargin_ns && ns <= last.ns + kMargin_ns) part.push_back(pose);
  }
  return part;
}

Comparison Compare(const RunReport& report) {
  Comparison result;
  result.charts.estimates = {{"estimate", report.trajectory}};
  result.charts.keyframes = report.keyframes;
  const auto pairs = AssociateStamps(StampsOf(report.reference), StampsOf(report.trajectory), kMaxDifference);
  if (pairs.size() < kLeastPairsToAlign) return result;
  const AbsoluteError error = ComputeAbsoluteError(report.reference, report.trajectory, pairs, EvalAlign::kSe3);
  result.charts.reference = ReferenceDuring(report);
  result.charts.estimates[0].poses = Aligned(error.reference_from_estimate, report.trajectory);
  result.charts.keyframes = Aligned(error.reference_from_estimate, report.keyframes);
  for (const StampPair& pair : pairs) result.errors.stamps.push_back(report.trajectory[pair.second].timestamp);
  result.errors.errors = error.errors;
  result.ate = error.summary;
  result.rpe = ComputeRelativeError(report.reference, report.trajectory, {});
  return result;
}

bool HasFigure(const RunReport& report, const std::string& word) {
  return std::any_of(report.key_figures.begin(), report.key_figures.end(),
                     [&](const auto& figure) { return figure.first.compare(0, word.size(), word) == 0; });
}

std::string Cards(const RunReport& report, const Comparison& comparison) {
  std::string cards;
  if (report.coverage && !HasFigure(report, "Coverage")) cards += ReportCard("Coverage", Percent(*report.coverage));
  if (comparison.ate && !HasFigure(report, "ATE")) cards += ReportCard("ATE RMSE, SE(3)", Length(comparison.ate->rmse));
  for (const auto& [label, value] : report.key_figures) cards += ReportCard(label, value);
  return cards.empty() ? cards : "<div class=\"cards\">\n" + cards + "</div>\n";
}

std::string TrajectorySection(const Comparison& comparison) {
  if (comparison.charts.estimates[0].poses.empty()) {
    return ReportSection("Trajectory", "<p>No pose was confirmed in this run.</p>\n");
  }
  std::string content = ChartSvg(TopViewChart(comparison.charts));
  for (const Chart& chart : CoordinateCharts(comparison.charts)) content += ChartSvg(chart);
  return ReportSection("Trajectory", content);
}

std::string ErrorSection(const Comparison& comparison) {
  if (!comparison.ate) return {};
  const Summary& ate = *comparison.ate;
  NamedErrors errors = comparison.errors;
  errors.name.clear();
  std::string content = ChartSvg(ErrorChart(comparison.charts, {errors}));
  content += "<p class=\"hint\">After SE(3) alignment, " + std::to_string(ate.count) + " pairs: RMSE " +
             Length(ate.rmse) + ", mean " + Length(ate.mean) + ", median " + Length(ate.median) + ", largest " +
             Length(ate.max) + ".";
  if (comparison.rpe.translation_summary.count > 0) {
    content += " Relative error over 1 s: " + Length(comparison.rpe.translation_summary.rmse) + ", " +
               FormatFixed(comparison.rpe.rotation_summary.rmse, 3) + " degrees (RMSE).";
  }
  content += "</p>\n";
  return ReportSection("Error against the reference", content);
}

/// Each state's stretches; a stretch ends where the next begins.
std::vector<ChartBand> StateBands(const std::vector<ReportFrame>& frames) {
  std::vector<ChartBand> bands;
  for (size_t begin = 0; begin < frames.size();) {
    size_t end = begin;
    while (end < frames.size() && frames[end].state == frames[begin].state) ++end;
    const StateColor& look = ColorOfState(frames[begin].state);
    const Timestamp until = frames[std::min(end, frames.size() - 1)].timestamp;
    const std::string name = *look.name != '\0' ? look.name : frames[begin].state;
    bands.push_back({SecondsBetween(frames[0].timestamp, frames[begin].timestamp),
                     SecondsBetween(frames[0].timestamp, until), look.color, name});
    begin = end;
  }
  return bands;
}

ChartSeries FrameSeries(const RunReport& report, const std::string& name, double (*value)(const ReportFrame&)) {
  ChartSeries series;
  series.name = name;
  for (const ReportFrame& frame : report.frames) {
    series.x.push_back(SecondsBetween(report.frames[0].timestamp, frame.timestamp));
    series.y.push_back(value(frame));
  }
  series.width_px = 1.3;
  return series;
}

std::string TrackingSection(const RunReport& report) {
  if (report.frames.empty()) return {};
  Chart states;
  states.title = "State";
  states.x_label = "time [s]";
  states.bands = StateBands(report.frames);
  states.height_px = 125;
  Chart matches;
  matches.title = "Matches";
  matches.x_label = "time [s]";
  matches.y_label = "points";
  matches.is_from_zero = true;
  matches.height_px = 250;
  matches.series = {FrameSeries(report, "matched", [](const ReportFrame& f) { return double(f.matched); }),
                    FrameSeries(report, "inliers", [](const ReportFrame& f) { return double(f.inliers); })};
  return ReportSection("Tracking", ChartSvg(states) + ChartSvg(matches));
}

std::string StageTable(const std::vector<ReportStage>& stages) {
  if (stages.empty()) return {};
  double longest = 1e-9;
  for (const ReportStage& stage : stages) longest = std::max(longest, stage.p95_ms);
  const auto bar = [&](const char* kind, double value) {
    return std::string("<i class=\"") + kind + "\" style=\"width:" + SvgNumber(100 * value / longest) + "%\"></i>";
  };
  std::string table =
      "<div class=\"scroll\"><table>\n<tr><th>stage</th><th>median [ms]</th><th>95 % [ms]</th>"
      "<th>largest [ms]</th><th>count</th><th></th></tr>\n";
  for (const ReportStage& stage : stages) {
    table += "<tr><td>" + EscapeXml(stage.name) + "</td>";
    for (const double value : {stage.median_ms, stage.p95_ms, stage.max_ms})
      table += "<td>" + (stage.count > 0 ? FormatFixed(value, 2) : std::string("-")) + "</td>";
    table += "<td>" + std::to_string(stage.count) + "</td><td class=\"bar\"><div class=\"track\">" +
             bar("p95", stage.p95_ms) + bar("median", stage.median_ms) + "</div></td></tr>\n";
  }
  return table +
         "</table></div>\n<p class=\"hint\">Bars: the median, and pale behind it the time that 95 % stay within.</p>\n";
}

std::string TimeSection(const RunReport& report) {
  std::string content = StageTable(report.stages);
  if (!report.frames.empty()) {
    Chart times;
    times.title = "Time a frame";
    times.x_label = "time [s]";
    times.y_label = "frame_total [ms]";
    times.is_from_zero = true;
    times.height_px = 230;
    times.series = {FrameSeries(report, "", [](const ReportFrame& f) { return f.frame_total_ms; })};
    content += ChartSvg(times);
  }
  return ReportSection("Time", content);
}

std::string NotesSection(const std::vector<std::string>& notes) {
  if (notes.empty()) return {};
  std::string list = "<ul>\n";
  for (const std::string& note : notes) list += "<li>" + EscapeXml(note) + "</li>\n";
  return ReportSection("Notes", list + "</ul>\n");
}

}  // namespace

std::string ReportHtml(const RunReport& report) {
  const Comparison comparison = Compare(report);
  std::string subtitle;
  if (!report.frames.empty()) {
    const double seconds = SecondsBetween(report.frames.front().timestamp, report.frames.back().timestamp);
    subtitle = std::to_string(report.frames.size()) + " frames, " + FormatFixed(seconds, 1) + " s";
  }
  std::string footer = report.version.empty() ? "yorb" : "yorb " + report.version;
  if (!report.config_digest.empty()) footer += ", configuration " + report.config_digest;
  const std::string content = Cards(report, comparison) + TrajectorySection(comparison) + ErrorSection(comparison) +
                              TrackingSection(report) + TimeSection(report) + NotesSection(report.notes);
  return ReportPage(report.title.empty() ? "Run" : report.title, subtitle, content, footer);
}

}  // namespace yorb

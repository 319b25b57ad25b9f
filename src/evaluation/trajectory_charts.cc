// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/trajectory_charts.h"

#include <algorithm>
#include <limits>

#include "core/stats.h"

namespace yorb {
namespace {

constexpr int kMapHeight_px = 520, kCoordinateHeight_px = 210, kErrorHeight_px = 260;
constexpr double kShortestGap = 0.5;  // seconds without a pose that are drawn as a gap
constexpr double kGapSteps = 8;       // ... or so many usual steps, where poses are rare
constexpr size_t kMostNamesBelow = 3;
constexpr const char* kAxisNames[] = {"x", "y", "z"};

double GapOf(const std::vector<double>& time) {
  std::vector<double> steps;
  for (size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  return std::max(kShortestGap, kGapSteps * Quantile(std::move(steps), 0.5));
}

std::vector<double> Seconds(const Trajectory& poses, Timestamp start) {
  std::vector<double> time;
  for (const StampedPose& pose : poses) time.push_back(SecondsBetween(start, pose.timestamp));
  return time;
}

std::vector<double> Coordinate(const Trajectory& poses, int axis) {
  std::vector<double> values;
  for (const StampedPose& pose : poses) values.push_back(pose.world_from_cam.translation[axis]);
  return values;
}

ChartSeries PathSeries(const std::string& name, const Trajectory& poses, int right, int up) {
  const std::vector<double> time = poses.empty() ? std::vector<double>() : Seconds(poses, poses.front().timestamp);
  return SeriesWithGaps(name, time, GapOf(time), Coordinate(poses, right), Coordinate(poses, up));
}

ChartSeries ReferenceStyle(ChartSeries series) {
  series.color = kChartReferenceColor;
  series.width_px = 2.4;
  return series;
}

/// The axis along which the trajectory moves least.
int FlatAxis(const Trajectory& poses) {
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const StampedPose& pose : poses) {
    low = low.min(pose.world_from_cam.translation.array());
    high = high.max(pose.world_from_cam.translation.array());
  }
  Eigen::Index axis = 2;
  if (!poses.empty()) (high - low).minCoeff(&axis);
  return static_cast<int>(axis);
}

/// An estimate looks the same in every chart; where the palette is used up, lines are dashed.
ChartSeries EstimateStyle(ChartSeries series, size_t index) {
  series.color = ChartPalette()[index % ChartPalette().size()];
  series.is_dashed = index >= ChartPalette().size();
  return series;
}

/// The name in the charts below the path: many are named there alone.
std::string NameBelow(const std::string& name, size_t num_estimates) {
  return num_estimates <= kMostNamesBelow ? name : std::string();
}

}  // namespace

Timestamp TrajectoryChartInput::Start() const {
  Timestamp start{std::numeric_limits<int64_t>::max()};
  if (!reference.empty()) start = reference.front().timestamp;
  for (const NamedTrajectory& estimate : estimates) {
    if (!estimate.poses.empty()) start = std::min(start, estimate.poses.front().timestamp);
  }
  return start;
}

AxisRange TrajectoryChartInput::TimeRange() const {
  Timestamp last = Start();
  if (!reference.empty()) last = std::max(last, reference.back().timestamp);
  for (const NamedTrajectory& estimate : estimates) {
    if (!estimate.poses.empty()) last = std::max(last, estimate.poses.back().timestamp);
  }
  const double length = SecondsBetween(Start(), last);
  return {0, length > 0 ? length : 1};
}

Chart TopViewChart(const TrajectoryChartInput& input) {
  const bool has_reference = !input.reference.empty();
  const Trajectory nothing;
  const Trajectory& largest = has_reference             ? input.reference
                              : input.estimates.empty() ? nothing
                                                        : input.estimates[0].poses;
  const int flat = FlatAxis(largest), right = flat == 0 ? 1 : 0, up = flat == 2 ? 1 : 2;
  Chart chart;
  chart.title = std::string("Path, seen along ") + kAxisNames[flat];
  chart.x_label = std::string(kAxisNames[right]) + " [m]";
  chart.y_label = std::string(kAxisNames[up]) + " [m]";
  chart.is_equal_aspect = true;
  chart.height_px = kMapHeight_px;
  if (has_reference) chart.series.push_back(ReferenceStyle(PathSeries("reference", input.reference, right, up)));
  for (size_t i = 0; i < input.estimates.size(); ++i) {
    const NamedTrajectory& estimate = input.estimates[i];
    chart.series.push_back(EstimateStyle(PathSeries(estimate.name, estimate.poses, right, up), i));
  }
  if (!input.keyframes.empty()) {
    ChartSeries keyframes{"keyframes", Coordinate(input.keyframes, right), Coordinate(input.keyframes, up)};
    keyframes.is_dots = true;
    keyframes.width_px = 4.5;
    keyframes.color = ChartPalette()[4];
    chart.series.push_back(std::move(keyframes));
  }
  return chart;
}

std::vector<Chart> CoordinateCharts(const TrajectoryChartInput& input) {
  const Timestamp start = input.Start();
  const auto series = [&](const std::string& name, const Trajectory& poses, int axis) {
    const std::vector<double> time = Seconds(poses, start);
    return SeriesWithGaps(name, time, GapOf(time), time, Coordinate(poses, axis));
  };
  std::vector<Chart> charts;
  for (int axis = 0; axis < 3; ++axis) {
    Chart chart;
    chart.title = std::string(kAxisNames[axis]) + " over time";
    chart.x_label = "time [s]";
    chart.y_label = std::string(kAxisNames[axis]) + " [m]";
    chart.height_px = kCoordinateHeight_px;
    chart.x_range = input.TimeRange();
    if (!input.reference.empty()) chart.series.push_back(ReferenceStyle(series("reference", input.reference, axis)));
    for (size_t i = 0; i < input.estimates.size(); ++i) {
      const NamedTrajectory& estimate = input.estimates[i];
      const std::string name = NameBelow(estimate.name, input.estimates.size());
      chart.series.push_back(EstimateStyle(series(name, estimate.poses, axis), i));
    }
    charts.push_back(std::move(chart));
  }
  return charts;
}

Chart ErrorChart(const TrajectoryChartInput& input, const std::vector<NamedErrors>& estimates) {
  const Timestamp start = input.Start();
  Chart chart;
  chart.title = "Absolute error over time";
  chart.x_label = "time [s]";
  chart.is_from_zero = true;
  chart.height_px = kErrorHeight_px;
  chart.x_range = input.TimeRange();
  double largest = 0;
  for (const NamedErrors& estimate : estimates) {
    for (const double error : estimate.errors) largest = std::max(largest, error);
  }
  const double unit = largest < 0.1 ? 1e3 : 1;
  chart.y_label = unit == 1 ? "error [m]" : "error [mm]";
  for (size_t i = 0; i < estimates.size(); ++i) {
    std::vector<double> time, errors;
    for (const Timestamp stamp : estimates[i].stamps) time.push_back(SecondsBetween(start, stamp));
    for (const double error : estimates[i].errors) errors.push_back(unit * error);
    const std::string name = NameBelow(estimates[i].name, estimates.size());
    chart.series.push_back(EstimateStyle(SeriesWithGaps(name, time, GapOf(time), time, errors), i));
  }
  return chart;
}

}  // namespace yorb

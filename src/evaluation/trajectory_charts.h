// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "evaluation/chart.h"
#include "geometry/trajectory.h"

namespace yorb {

/// A trajectory as the charts show it: already aligned, under the name that the legend gives it.
struct NamedTrajectory {
  std::string name;
  Trajectory poses;
};

/// The error of one estimate over time.
struct NamedErrors {
  std::string name;
  std::vector<Timestamp> stamps;
  std::vector<double> errors;  ///< metres, one a stamp
};

/// What several charts of one evaluation have in common. The reference and the keyframes may be empty.
struct TrajectoryChartInput {
  Trajectory reference;
  std::vector<NamedTrajectory> estimates;
  Trajectory keyframes;

  /// Zero of the time axes: the first stamp of all.
  Timestamp Start() const;

  /// The time axes: seconds from Start() to the last stamp of all.
  AxisRange TimeRange() const;
};

/// The path seen along the axis with the least movement, which is from above for a camera that is carried or driven.
Chart TopViewChart(const TrajectoryChartInput& input);

/// x, y and z over time.
std::vector<Chart> CoordinateCharts(const TrajectoryChartInput& input);

/// The absolute error over time, on the time axis of `input`.
Chart ErrorChart(const TrajectoryChartInput& input, const std::vector<NamedErrors>& estimates);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "datasets/light.h"
#include "geometry/trajectory.h"
#include "system/config.h"

namespace yorb {

class Dataset;

/// A way to find the points of a picture, under its name in the table.
struct NamedFeatures {
  std::string name;
  FeatureOptions features;
};

/// ORB-SLAM2's front end with its own thresholds (20/7) and with those that the paper compares with (40/30), and the
/// one that the configuration asks for.
std::vector<NamedFeatures> LightFrontEnds(const FeatureOptions& ours);

/// What is run.
struct LightBenchOptions {
  Config config;                  ///< mode and dynamics are not used: inline, so that it repeats to the bit, and off
  std::vector<LightKind> lights;  ///< steady light is always run, for comparison
  int num_seeds = 1;              ///< the config's and the following, of light and of SLAM alike
  Trajectory truth;               ///< empty: no errors
};

/// What one frame came to.
struct LightFrame {
  double seconds = 0;     ///< since the start of the recording
  double brightness = 0;  ///< mean grey level; NaN where the picture could not be read
  int num_features = 0;
  int num_points = 0;  ///< tracked: 0 where the pose is not confirmed
};

/// One run: one light, one front end, one seed.
struct LightRun {
  LightKind light = LightKind::kSteady;
  std::string front_end;
  int64_t seed = 0;
  std::vector<LightFrame> frames;
  double coverage = 0;
  std::optional<double> ate_m;
  double wall_s = 0;
};

/// What the bench tells and asks meanwhile. Each may be empty.
struct LightBenchHooks {
  std::function<bool()> should_stop;
  std::function<void(size_t num_done, size_t num_frames)> on_frame;  ///< frames of all runs together
  std::function<void(const LightRun&)> on_run;
};

/// All runs: light by light, front end by front end, seed by seed.
struct LightReport {
  std::vector<LightRun> runs;
  bool was_stopped = false;  ///< the runs that were done by then are there
};

/// Runs a recording under each light with each front end.
Result<LightReport> MeasureLight(const Dataset& dataset, const LightBenchOptions& options,
                                 const LightBenchHooks& hooks);

}  // namespace yorb

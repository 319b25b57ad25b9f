// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "datasets/dataset.h"
#include "evaluation/evaluate.h"
#include "experiments/removal_score.h"
#include "system/config.h"

namespace yorb {

/// The ways to deal with moving things that are compared, as the command line and the JSON name them.
namespace dynamic_way {
inline const std::string kOriginal = "original";     ///< nothing is removed; ORB-SLAM2's front end: the measure
inline const std::string kOff = "off";               ///< nothing is removed
inline const std::string kPaper = "paper";           ///< the paper's rules, the detector's boxes
inline const std::string kFull = "full";             ///< ours, the detector's boxes
inline const std::string kFullExact = "full-exact";  ///< ours, the true boxes
}  // namespace dynamic_way

/// All of them, in the order of the tables.
const std::vector<std::string>& DynamicWays();

/// A recording, and what is known of it. The truth is the bench's alone: only `full-exact` is given `people`.
struct DynamicSequence {
  std::string name;
  const Dataset* dataset = nullptr;
  Trajectory truth;    ///< empty: no errors
  std::string people;  ///< the file of the true boxes; empty: no `full-exact`
  std::string masks;   ///< the folder of the true masks; empty: nothing is said of the removal
};

/// What is run.
struct DynamicBenchOptions {
  Config config;                  ///< of all ways; what they differ in is not used
  std::vector<std::string> ways;  ///< empty: all
  int num_runs = 1;               ///< of each, with the config's seed and the following
};

/// One run: one recording, one way, one seed.
struct DynamicRun {
  std::string sequence, way;
  int64_t seed = 0;
  size_t num_frames = 0;
  double coverage = 0;
  std::optional<Evaluation> evaluation;        ///< where there is truth, and enough of a trajectory
  double num_removed = 0, num_given_back = 0;  ///< points a picture
  std::optional<RemovalScore> removal;
  std::map<std::string, std::vector<double>> stage_ms;
  double wall_s = 0;
};

/// What the bench tells and asks meanwhile. Each may be empty.
struct DynamicBenchHooks {
  std::function<bool()> should_stop;
  std::function<void(size_t num_done, size_t num_frames)> on_frame;  ///< frames of all runs together
  std::function<void(const DynamicRun&)> on_run;
};

/// All runs: sequence by sequence, way by way, seed by seed.
struct DynamicReport {
  std::vector<DynamicRun> runs;
  bool was_stopped = false;    ///< the runs that were done by then are there
  std::optional<Error> error;  ///< what ended it after these runs
};

/// Runs each recording in each way. An error before the first run is done is the result, a later one a part of it.
Result<DynamicReport> MeasureDynamic(const std::vector<DynamicSequence>& sequences, const DynamicBenchOptions& options,
                                     const DynamicBenchHooks& hooks);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: evaluation. How far an estimated trajectory is from the true one, and pictures of it.
// Takes: trajectories and what a run says about itself. Gives: errors, charts, report.html. Owns: nothing.
// Runs on: whichever thread calls. May not: run SLAM, read pictures, print.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "evaluation/ate.h"
#include "evaluation/rpe.h"
#include "evaluation/trajectory_io.h"

namespace yorb {

/// What an evaluation depends on besides the two trajectories.
struct EvalOptions {
  EvalAlign align = EvalAlign::kSe3;
  double rpe_delta = 1;
  RpeUnit rpe_unit = RpeUnit::kSeconds;
  double max_difference = 0.02;                    ///< seconds, exclusive, between two poses that belong together
  double time_offset = 0;                          ///< seconds, added to the estimate
  std::optional<std::vector<Timestamp>> pictures;  ///< of the sequence, for coverage
  std::optional<size_t> num_frames;                ///< of the sequence, for coverage without stamps
};

/// Bad input where an option is out of its range.
Status Validate(const EvalOptions& options);

/// One estimate against the reference.
struct Evaluation {
  std::string estimate_path;
  Trajectory estimate;           ///< as read
  Trajectory aligned;            ///< in the reference's frame and clock
  std::vector<StampPair> pairs;  ///< first: of the reference, second: of the estimate
  AbsoluteError ate;
  RelativeError rpe;
  std::optional<double> coverage;
  std::vector<std::string> warnings;
};

/// Associates, aligns and measures. Rows without stamps are paired by their numbers; a warning says where there are not
/// as many. Bad input where nothing belongs together (with both ranges of time), fewer than three pairs do, or a time
/// offset is given where there are no stamps.
Result<Evaluation> Evaluate(const ReadTrajectory& reference, const ReadTrajectory& estimate,
                            const EvalOptions& options);

}  // namespace yorb

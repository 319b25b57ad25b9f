// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: experiments. The paper's tables and figures as functions, behind `yorb bench`.
// Takes: Dataset, Config. Gives: values, and their text and JSON. Owns: nothing.
// Runs on: the caller's thread. May not: print, write files.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "datasets/dataset.h"
#include "evaluation/report.h"
#include "system/config.h"

namespace yorb {

/// How long the stages of a run take, beside OpenCV's ORB on pictures of the same recording.
struct SpeedReport {
  size_t frames = 0, tracked = 0;
  std::string mode, dynamics;
  std::vector<ReportStage> stages;  ///< as in metrics.json
  ReportStage cv_orb;               ///< cv::ORB::create(1000)->detectAndCompute, one thread

  /// Median of a whole frame in units of the median of cv_orb; NaN where either was not measured.
  double Ratio() const;
};

/// Runs the recording once, as `yorb run` would (detector, masks, map and all), with cv::ORB on some of its pictures
/// before and after, so that both meet the machine in the same state. Sets OpenCV to one thread while it works.
Result<SpeedReport> MeasureSpeed(const Dataset& dataset, const Config& config,
                                 const std::function<bool()>& should_stop);

/// A table for people.
std::string SpeedText(const SpeedReport& report);

/// {"frames", "tracked", "mode", "dynamics", "stages", "cv_orb", "ratio"}.
std::string SpeedJson(const SpeedReport& report);

}  // namespace yorb

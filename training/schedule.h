// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/stopwatch.h"

namespace yorb {

/// Sizes of the network's input, used until a part of the training is done.
struct SizePhase {
  double until = 1;                         ///< part of the training, 0 to 1
  std::vector<cv::Size> sizes{{320, 256}};  ///< in turn, batch by batch; measured at the first
};

/// Reads "224x192:0.4,320x256+416x320": sizes in multiples of 32, those that take turns joined by +, and the part of
/// the training at which each phase ends.
Result<std::vector<SizePhase>> ParseSizePhases(const std::string& text);

struct ScheduleOptions {
  int64_t num_steps = 0;  ///< the whole training, in steps; 0: `minutes` counts
  double minutes = 0;     ///< the whole training, in time, whatever the machine makes of it
  int64_t num_warmup_steps = 300;
  double last_rate = 0.02;  ///< the learning rate at the end, in parts of the highest
  std::vector<SizePhase> phases{{}};
};

/// Where a training stands between its beginning and its end. Any thread may ask.
class Schedule {
 public:
  /// `seconds_before` went into the training before it was resumed.
  Schedule(const ScheduleOptions& options, double seconds_before)
      : options_(options), seconds_before_(seconds_before) {}

  double Seconds() const { return seconds_before_ + watch_.seconds(); }

  /// From 0 to 1, by steps or by time.
  double Progress(int64_t step) const;

  /// The learning rate in parts of the highest: a linear warm-up, then half a cosine.
  double Rate(int64_t step) const;

  cv::Size SizeAt(int64_t step) const;

 private:
  ScheduleOptions options_;
  double seconds_before_;
  Stopwatch watch_;
};

}  // namespace yorb

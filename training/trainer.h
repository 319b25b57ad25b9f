// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "training/distill.h"
#include "training/evaluate.h"
#include "training/loader.h"
#include "training/loss.h"
#include "training/schedule.h"
#include "training/train_state.h"

namespace yorb {

/// A set that is measured on now and then.
struct WatchedSet {
  std::string name;
  std::shared_ptr<const Composer> pictures;
};

struct TrainerOptions {
  ScheduleOptions schedule;
  LossOptions loss;
  std::optional<Teacher> teacher;
  double teacher_weight = 1;  ///< of what the teacher says, against the truth
  std::string out;            ///< folder for checkpoints and logs
  double save_every_s = 120;
  double evaluate_every_s = 900;
  torch::Device device = torch::kCPU;
  int num_loading_threads = 1;  ///< that make batches, beside the training
  bool is_half_wide =
      false;  ///< convolutions in bfloat16, weights and loss in float: faster where the machine knows it
};

/// Means since the last report.
struct TrainReport {
  int64_t step = 0;
  int64_t num_steps = 0;  ///< that the means are over
  double progress = 0, seconds = 0, pictures_per_second = 0;
  cv::Size size;
  double rate = 0;
  double box = 0, objectness = 0, classes = 0, teacher = 0;
};

/// Trains until the schedule ends, or `should_stop` says so; then the checkpoint OUT/last.pt is written. The log grows
/// in OUT/train.csv (a line a report) and OUT/scores.csv (a line a set and evaluation).
/// Runs on: the caller's thread; batches are made by `num_loading_threads` beside it.
class Trainer {
 public:
  Trainer(TrainState& state, Loader loader, std::vector<WatchedSet> watched, const TrainerOptions& options);

  Status Run(const std::function<void(const TrainReport&)>& report, const std::function<bool()>& should_stop);

 private:
  Loss Step(const Batch& batch, double rate);
  Loss LossOf(const Batch& batch);
  Status EvaluateAll();
  Status Report(const TrainReport& report);

  TrainState& state_;
  Loader loader_;
  std::vector<WatchedSet> watched_;
  TrainerOptions options_;
  Schedule schedule_;
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "core/result.h"
#include "training/people_features.h"
#include "training/people_head.h"

namespace yorb {

struct PeopleTrainerOptions {
  int epochs = 4;
  int64_t batch_size = 16;
  double rate = 0.004;  ///< the highest of the schedule
  double weight_decay = 0.001;
  uint64_t seed = 1;  ///< of the order of the pictures
};

/// How well cells are told apart: a person's where the label, or the probability, is above one half.
struct CellScores {
  double iou = 0, precision = 0, recall = 0;
};

/// On cells that have a label. A share of nothing is 0.
CellScores MeasureCells(PeopleHead head, const FeatureSet& set);

/// How far a training is.
struct PeopleReport {
  int epoch = 0;  ///< from 1
  int64_t step = 0, num_steps = 0;
  double loss = 0;  ///< mean since the last report
  bool is_end_of_epoch = false;
};

/// Trains the head with the cross-entropy of the cells. `report` hears now and then, and at the end of each epoch, how
/// far it is; `should_stop` is asked at every step, and ends it with a failure.
Status TrainPeopleHead(PeopleHead head, const FeatureSet& set, const PeopleTrainerOptions& options,
                       const std::function<void(const PeopleReport&)>& report,
                       const std::function<bool()>& should_stop);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "training/class_table.h"
#include "training/network.h"

namespace yorb {

struct OptimizerOptions {
  double rate = 0.0015;        ///< the highest learning rate of the head
  double backbone_part = 0.5;  ///< the backbone's, in parts of the head's
  double weight_decay = 0.02;  ///< of convolutions; biases and norms do not decay
  double averaging = 0.999;    ///< the averaged network's memory, per step
};

/// All that a training is made of; a checkpoint holds it whole.
struct TrainState {
  TrainState(const Layout& layout, const ClassTable& table, const OptimizerOptions& options);

  ClassTable table;
  OptimizerOptions options;
  Network network{nullptr};
  Network average{nullptr};  ///< the moving average of the weights: what is measured and exported
  std::unique_ptr<torch::optim::AdamW> optimizer;
  int64_t step = 0;
  double seconds = 0;  ///< of training so far
};

/// The learning rates of all groups of weights, `rate` in parts of the highest.
void SetRate(TrainState& state, double rate);

/// Moves the averaged network a little towards the trained one.
void UpdateAverage(TrainState& state);

/// Writes a checkpoint whole, in place of the one before.
Status SaveCheckpoint(const std::string& path, TrainState& state);

/// Reads a checkpoint, onto the device on which the network is. Bad input when it is none, or one of another network
/// than `state` holds.
Status LoadCheckpoint(const std::string& path, TrainState& state);

/// Begins anew from the averaged weights of a checkpoint. Bad input as above.
Status BeginFrom(const std::string& path, TrainState& state);

/// Moves the averaged network to the mean of itself and those of other checkpoints of the same kind. Bad input as
/// above.
Status AverageWith(const std::vector<std::string>& paths, TrainState& state);

/// What a checkpoint is of.
struct CheckpointKind {
  std::string layout;
  ClassTable table;
};
Result<CheckpointKind> ReadCheckpointKind(const std::string& path);

}  // namespace yorb

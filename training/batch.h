// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <vector>

#include "training/scene.h"

namespace yorb {

/// A true box and the picture of the batch that it is in.
struct Target {
  int picture = 0;
  SceneBox box;
};

/// What one step learns from.
struct Batch {
  torch::Tensor pictures;  ///< (B, H, W, 3), 8 bits, RGB
  std::vector<Target> targets;
  torch::Tensor judged;  ///< (B, classes), 1 where the absence of a class from the truth means something
};

/// Scenes of one size, as a batch. `is_pinned`: in memory that a GPU reads by itself (libtorch must have one).
Batch MakeBatch(const std::vector<Scene>& scenes, int num_classes, bool is_pinned = false);

/// Pictures of a batch as the network takes them: (B, 3, H, W) in [0, 1], channels last in memory.
torch::Tensor ToInput(const torch::Tensor& pictures, const torch::Device& device);

}  // namespace yorb

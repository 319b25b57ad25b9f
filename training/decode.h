// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <array>
#include <vector>

#include "training/layout.h"
#include "training/scene.h"

namespace yorb {

/// A thing that the network sees, in pixels of its input.
struct Detection {
  SceneBox box;
  float confidence = 0;
};

struct DecodeOptions {
  double least_confidence = 0.001;
  double most_overlap = 0.6;  ///< IoU above which the weaker of two boxes of one class goes
  size_t most_boxes = 300;
};

/// The things in each picture of a batch, by falling confidence, from the logits of the three heads: objectness times
/// class, boxes as YOLOv5 decodes them, one list for all classes, suppression class by class.
std::vector<std::vector<Detection>> DecodeBoxes(const std::array<torch::Tensor, 3>& maps, const Layout& layout,
                                                const DecodeOptions& options);

}  // namespace yorb

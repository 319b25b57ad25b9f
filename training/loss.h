// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <array>

#include "training/assign.h"
#include "training/batch.h"
#include "training/layout.h"

namespace yorb {

/// Weights of the parts of the loss.
struct LossOptions {
  double box = 0.05;
  double objectness = 0.7;
  double classes = 0.3;
  /// How much it counts to see a class that a picture is not judged for where there is nothing, or in a thing of
  /// another class: from 0, not at all, to 1, as much as anything else.
  double unjudged = 1;
  std::array<double, 3> level_objectness{4.0, 1.0, 0.4};  ///< small things have most cells, and these the least signal
};

/// The loss of a batch and its parts, each a mean over the batch.
struct Loss {
  torch::Tensor total;  ///< times the batch size: what is differentiated
  double box = 0, objectness = 0, classes = 0, teacher = 0;
};

/// YOLOv5's loss (CIoU of boxes, binary cross entropies of objectness and classes). Truth is incomplete: a class that a
/// picture is not judged for may count less in its class loss, and so may the background where the network itself sees
/// such a class.
Loss DetectionLoss(const std::array<torch::Tensor, 3>& maps, const Batch& batch, const Layout& layout,
                   const LossOptions& options);

/// A head's map (B, 3 * (5 + classes), rows, columns) as floats (B, rows, columns, anchors, 5 + classes).
torch::Tensor ByCells(const torch::Tensor& map);

/// Where an assignment's cells stand in such a map.
std::vector<at::indexing::TensorIndex> CellIndex(const Assignment& cells, const torch::Device& device);

/// Boxes (n, 4), centre from the cell's corner, width, height in cells, of logits (n, 4 or more): a centre reaches half
/// a cell beyond its own, a side up to four times its anchor's.
torch::Tensor DecodeAtCells(const torch::Tensor& logits, const torch::Tensor& anchors);

/// How well the boxes at an assignment's cells fit the truth, from 0 to 1, as it is (without a gradient): the
/// objectness that is wanted there.
torch::Tensor WantedObjectness(const torch::Tensor& map, const Assignment& cells);

/// Complete IoU of boxes (n, 4) as centre x, y, width, height; the weight of its aspect term is held constant.
torch::Tensor CompleteIou(const torch::Tensor& a, const torch::Tensor& b);

}  // namespace yorb

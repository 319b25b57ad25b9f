// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <string>

#include "core/result.h"
#include "training/class_table.h"
#include "training/network.h"

namespace yorb {

/// Reads the weights of an ONNX file that `ExportOnnx` wrote, the released ones for example, into a network that can be
/// trained again. Norms are folded into the convolutions there; each gets mean and deviation of what its convolution
/// gives for `pictures` (B, 3, H, W in [0, 1], on the network's device; some dozens), and scale and shift such that the
/// network's values are the file's. Classes go by name; those of `table` that the file does not know stay as they are
/// in `network`. Bad input when weights are missing or of another shape (another network), or the file names no class
/// for each channel; the network is undefined then.
Status ReadFoldedWeights(const std::string& path, const ClassTable& table, const torch::Tensor& pictures,
                         Network network);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "training/blocks.h"
#include "training/layout.h"

namespace yorb {

/// A detector that can be trained.
/// Takes: pictures (B, 3, H, W), RGB in [0, 1], H and W multiples of 32.
/// Gives: logits of the three heads, (B, 3 * (5 + classes), H / stride, W / stride); see `DecodeBoxes` for their
/// meaning.
struct NetworkImpl : torch::nn::Module {
  explicit NetworkImpl(const Layout& network_layout);
  std::array<torch::Tensor, 3> forward(const torch::Tensor& pictures);

  /// The parameters of the backbone; the others belong to the head.
  std::vector<torch::Tensor> BackboneParameters() const;

  Layout layout;
  std::vector<std::shared_ptr<RowImpl>> rows;
  std::array<torch::nn::Conv2d, 3> heads{{{nullptr}, {nullptr}, {nullptr}}};
};
TORCH_MODULE(Network);

/// Copies the weights of an ImageNet backbone (a TorchScript archive whose tensors are named "0.conv.weight",
/// "1.dw.bn.running_mean" and so on) into the rows of the same names. Bad input when one is missing or of another
/// shape.
Status LoadBackbone(const std::string& path, Network network);

/// ImageNet's mean and deviation, with which the backbone was trained: (x - mean) / deviation for RGB in [0, 1].
torch::Tensor NormalizePictures(const torch::Tensor& pictures);

/// Mean and deviation that `NormalizePictures` uses, in the order R, G, B.
std::array<float, 3> PictureMean();
std::array<float, 3> PictureDeviation();

/// For weights from a file whose first convolution reads pictures in [0, 1] (its norm folded): from now on it reads
/// normalised ones, as the network gives it.
void UnfoldNormalisation(Network network);

}  // namespace yorb

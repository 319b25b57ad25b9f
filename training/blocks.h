// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

#include <vector>

#include "training/layout.h"

namespace yorb {

torch::Tensor Activate(const torch::Tensor& x, Activation activation);

/// What a convolution with batch norm is made of.
struct ConvSpec {
  int in = 0, out = 0;
  int kernel = 1, stride = 1, padding = 0, groups = 1;
  Activation activation = Activation::kNone;
  double norm_epsilon = 1e-3;
};

/// Convolution without bias, batch norm, activation.
struct ConvNormImpl : torch::nn::Module {
  explicit ConvNormImpl(const ConvSpec& spec);
  torch::Tensor forward(const torch::Tensor& x);

  /// For weights in which the norm is folded: in evaluation mode it adds its bias (zero, for now) and no more.
  void HoldFolded();

  /// For a norm with other statistics than its data have (one that was folded): takes mean and deviation from `y`, what
  /// the convolution gives, and scale and shift such that evaluation mode stays what it was.
  void TakeStatistics(const torch::Tensor& y);

  ConvSpec spec;
  bool takes_statistics = false;  ///< `forward` calls `TakeStatistics` first
  torch::nn::Conv2d conv{nullptr};
  torch::nn::BatchNorm2d bn{nullptr};
};
TORCH_MODULE(ConvNorm);

/// Weighs the channels by what the whole picture holds. Squeezes to a quarter, in multiples of 8.
struct SqueezeExciteImpl : torch::nn::Module {
  explicit SqueezeExciteImpl(int channels);
  torch::Tensor forward(const torch::Tensor& x);

  torch::nn::Conv2d fc1{nullptr}, fc2{nullptr};
};
TORCH_MODULE(SqueezeExcite);

/// A row of a layout as a module.
struct RowImpl : torch::nn::Module {
  virtual torch::Tensor Run(const std::vector<torch::Tensor>& inputs) = 0;
};

struct ConvRow : RowImpl {
  ConvRow(const LayerSpec& spec, int in);
  torch::Tensor Run(const std::vector<torch::Tensor>& inputs) override;

  ConvNorm conv_norm{nullptr};
};

/// The inverted residual of MobileNetV3, squeeze-and-excite after the depth-wise activation as its ImageNet weights
/// were trained.
struct MobileBlock : RowImpl {
  MobileBlock(const LayerSpec& spec, int in);
  torch::Tensor Run(const std::vector<torch::Tensor>& inputs) override;

  bool has_shortcut = false;
  ConvNorm expand{nullptr}, dw{nullptr}, project{nullptr};  ///< no `expand` where the widths agree
  SqueezeExcite se{nullptr};                                ///< null where the row has none
};

struct BottleneckImpl : torch::nn::Module {
  BottleneckImpl(int channels, const LayerSpec& spec);
  torch::Tensor forward(const torch::Tensor& x);

  bool has_shortcut = false;
  ConvNorm cv1{nullptr}, cv2{nullptr};
};
TORCH_MODULE(Bottleneck);

struct C3Row : RowImpl {
  C3Row(const LayerSpec& spec, int in);
  torch::Tensor Run(const std::vector<torch::Tensor>& inputs) override;

  ConvNorm cv1{nullptr}, cv2{nullptr}, cv3{nullptr};
  std::vector<Bottleneck> bottlenecks;
};

struct SppfRow : RowImpl {
  SppfRow(const LayerSpec& spec, int in);
  torch::Tensor Run(const std::vector<torch::Tensor>& inputs) override;

  int kernel = 5;
  ConvNorm cv1{nullptr}, cv2{nullptr};
};

struct UpsampleRow : RowImpl {
  torch::Tensor Run(const std::vector<torch::Tensor>& inputs) override;
};

struct ConcatRow : RowImpl {
  torch::Tensor Run(const std::vector<torch::Tensor>& inputs) override { return torch::cat(inputs, 1); }
};

}  // namespace yorb

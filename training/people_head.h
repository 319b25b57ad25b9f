// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <torch/torch.h>

namespace yorb {

/// Says of every cell of stride 8 how likely it shows a person, from a detector's maps of strides 8 and 16: each is
/// reduced to few channels, the coarse one enlarged and added; then the cells around have their say.
struct PeopleHeadImpl : torch::nn::Module {
  PeopleHeadImpl(int64_t fine_channels, int64_t coarse_channels, int64_t width = 32);

  /// Logits (B, 1, H, W) from (B, fine, H, W) and (B, coarse, H / 2, W / 2).
  torch::Tensor forward(const torch::Tensor& fine_map, const torch::Tensor& coarse_map);

  torch::nn::Conv2d fine{nullptr}, coarse{nullptr}, mix{nullptr}, out{nullptr};
};
TORCH_MODULE(PeopleHead);

}  // namespace yorb

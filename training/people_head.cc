// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_head.h"

namespace yorb {

using torch::nn::Conv2dOptions;

PeopleHeadImpl::PeopleHeadImpl(int64_t fine_channels, int64_t coarse_channels, int64_t width)
    : fine(register_module("fine", torch::nn::Conv2d(Conv2dOptions(fine_channels, width, 1)))),
      coarse(register_module("coarse", torch::nn::Conv2d(Conv2dOptions(coarse_channels, width, 1).bias(false)))),
      mix(register_module("mix", torch::nn::Conv2d(Conv2dOptions(width, width, 3).padding(1)))),
      out(register_module("out", torch::nn::Conv2d(Conv2dOptions(width, 1, 1)))) {}

torch::Tensor PeopleHeadImpl::forward(const torch::Tensor& fine_map, const torch::Tensor& coarse_map) {
  namespace F = torch::nn::functional;
  const auto twice = F::InterpolateFuncOptions().scale_factor(std::vector<double>{2, 2}).mode(torch::kNearest);
  const torch::Tensor both = fine(fine_map) + F::interpolate(coarse(coarse_map), twice);
  return out(torch::relu(mix(torch::relu(both))));
}

}  // namespace yorb

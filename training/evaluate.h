// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "training/average_precision.h"
#include "training/compose.h"
#include "training/network.h"

namespace yorb {

/// Scores of a network on letterboxed pictures.
struct Evaluation {
  std::vector<ClassScore> classes;  ///< those with truth
  double map50 = 0, map = 0;        ///< their means
};

/// Runs the network, which is in evaluation mode afterwards, over all pictures of the composer.
Evaluation Evaluate(Network network, const Composer& pictures, const cv::Size& size, const torch::Device& device);

}  // namespace yorb

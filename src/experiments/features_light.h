// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace yorb {

/// A change of light as a table of grey levels.
struct LightChange {
  std::string name;  ///< "x0.6", "-40", "gamma 2", "half dark"
  std::array<uint8_t, 256> levels{};
  bool is_left_half = false;  ///< only the left half of the picture changes
};

/// Brightness of `factor`: rounded, cut off at white.
LightChange Scaled(double factor);

/// What the experiments try beside the untouched picture: 60 and 140 % brightness as the paper, 40 grey levels less and
/// more, gamma 0.5 and 2, and a picture whose left half has 30 % of its light.
std::vector<LightChange> LightChanges();

/// `grey` (CV_8UC1) under another light.
cv::Mat Relit(const cv::Mat& grey, const LightChange& change);

}  // namespace yorb

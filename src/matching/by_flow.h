// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace yorb {

/// Where a point was in one picture, and where in the next one it is expected; real pixels.
struct FlowGuess {
  Eigen::Vector2f from_px, to_px;
};

/// Follows points from one grey picture to the next by their surroundings (pyramidal Lucas-Kanade, Bouguet 2001), as
/// long as the way back leads to where they came from. Unlike descriptors it needs no corner in the second picture:
/// blur of a quick turn, and textures that repeat, do it little harm. Nothing for a point that it loses. Both pictures
/// are CV_8UC1 and of one size.
std::vector<std::optional<Eigen::Vector2f>> FollowByFlow(const cv::Mat& from, const cv::Mat& to,
                                                         const std::vector<FlowGuess>& guesses);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "camera/rig.h"

namespace yorb {

/// How far from perfect the sensors are.
struct SensorOptions {
  double noise = 1;   ///< 0: exact; 1: like a Kinect of the first kind; scales deviations and the number of holes
  uint64_t seed = 1;  ///< a frame's noise depends on this and its number alone
};

/// Adds a colour sensor's grain, stronger in the dark, to a CV_8UC3 picture.
void AddColourNoise(const SensorOptions& options, uint64_t frame, cv::Mat& colour);

/// What the depth sensor makes of exact metres (CV_32FC1): 16-bit units (CV_16UC1), 0 where it sees nothing. With
/// noise: disparity in steps of an eighth of a pixel with an error that neighbours share, so that the error of depth
/// grows with its square; no depth in the projector's shadow beside near things, below 0.45 m, and more and more holes
/// from 4.5 m on, at grazing angles and along edges.
cv::Mat MeasureDepth(const SensorOptions& options, uint64_t frame, const Rig& rig, const cv::Mat& exact);

}  // namespace yorb

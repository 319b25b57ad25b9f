// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "motion/depth_grid.h"

namespace yorb {

/// What a tracker may look at beside the points of a frame; each may be empty.
struct Sight {
  DepthGrid depth;    ///< what moves is looked for in it, and surfaces hold a pose that its points leave unsure
  cv::Mat grey;       ///< CV_8UC1: points that descriptors do not find again are followed in it
  cv::Mat covered;    ///< CV_8UC1, in cells of some pixels: non-zero on moving things and under the user's masks
  double hidden = 0;  ///< share of the picture that is behind moving things
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "core/random.h"

namespace yorb {

/// How light and camera are varied.
struct PhotometricOptions {
  double hue = 0.015, saturation = 0.6, brightness = 0.4;  ///< gains lie within 1 -+ these
  double blur = 0.15;                                      ///< share of blurred pictures: out of focus, or moved
  double noise = 0.2;                                      ///< share of noisy pictures
  double most_noise = 12;                                  ///< deviation in grey values
  double grey = 0.03;                                      ///< share of pictures without colour
  double jpeg = 0;                                         ///< share of pictures that were compressed once more
};

/// Changes the picture as light, a cheap lens and a small sensor would.
void VaryLight(const PhotometricOptions& options, cv::Mat pixels, Random& random);

}  // namespace yorb

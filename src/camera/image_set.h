// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <opencv2/core.hpp>

#include "core/time.h"

namespace yorb {

/// Depth as the sensor delivers it: 16-bit units (0 and 65535: not measured) or 32-bit float metres; registered to the
/// colour picture and of its size. May be empty: a frame without depth.
struct DepthImage {
  cv::Mat pixels;              ///< CV_16UC1 or CV_32FC1
  double metres_per_unit = 1;  ///< 1 / depth factor for 16-bit pixels, not used for float ones

  bool empty() const { return pixels.empty(); }

  static constexpr double kBeyondAnyCamera = 1e6;  ///< metres from which on a depth is none

  /// What the picture and the factor say of a pixel inside of it, in metres and be it absurd; 0 where 16-bit pixels say
  /// that nothing was measured.
  double StoredMetres(int x, int y) const {
    if (pixels.type() != CV_16UC1) return pixels.at<float>(y, x);
    const uint16_t units = pixels.at<uint16_t>(y, x);
    return units == 65535 ? 0.0 : units * metres_per_unit;
  }

  /// Metres along the optical axis at a pixel inside of the picture; 0 where nothing was measured.
  float At(int x, int y) const {
    const double metres = StoredMetres(x, y);
    return metres > 0 && metres < kBeyondAnyCamera ? static_cast<float>(metres) : 0.f;
  }
};

/// What a camera delivers at one moment. Moved from hand to hand; the pixels are never written again.
struct ImageSet {
  Timestamp timestamp;
  cv::Mat grey;    ///< CV_8UC1
  cv::Mat colour;  ///< CV_8UC3, BGR; empty where the source is grey
  DepthImage depth;
  cv::Mat ignored;  ///< CV_8UC1 of the picture's size: pixels that are not 0 are not to be used; empty: all are
};

}  // namespace yorb

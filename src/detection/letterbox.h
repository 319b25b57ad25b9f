// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace yorb {

/// How a picture is fitted into the input of a network: scaled as a whole, so that nothing is squashed, and set into
/// the middle of grey bars.
struct Letterbox {
  cv::Size picture, input, scaled;  ///< px; `scaled`: the picture within the input
  int left = 0, top = 0;            ///< of the scaled picture in the input, px

  /// Coordinates of the picture from those of the input.
  double ToPictureX(double x) const { return (x - left) * picture.width / scaled.width; }
  double ToPictureY(double y) const { return (y - top) * picture.height / scaled.height; }
};

/// Sizes must not be empty.
Letterbox FitLetterbox(const cv::Size& picture, const cv::Size& input);

/// The input of the network: `picture` (8-bit, any number of channels) scaled and framed.
cv::Mat Letterboxed(const cv::Mat& picture, const Letterbox& box);

}  // namespace yorb

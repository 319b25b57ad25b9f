// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace yorb {

/// Whether a mask (CV_8UC1) that lies over a whole picture of `size`, in cells of whatever size, marks a pixel inside
/// of that picture. An empty one marks nothing.
inline bool IsMarked(const cv::Mat& mask, const cv::Point& pixel, const cv::Size& size) {
  if (mask.empty()) return false;
  return mask.at<uint8_t>(pixel.y * mask.rows / size.height, pixel.x * mask.cols / size.width) != 0;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/read_picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "pictures/picture_file.h"

namespace yorb {

Result<cv::Mat> ReadSmallPicture(const std::string& path, int long_side_px) {
  const StoredPicture stored = ReadPictureFile(path);
  if (stored.pixels.empty()) return BadInput(path + ": " + stored.fault);
  const Result<ColourAndGrey> picture = ToColourAndGrey(stored.pixels, path);
  if (!picture) return picture.error();
  cv::Mat pixels = picture->colour;
  if (pixels.empty()) cv::cvtColor(picture->grey, pixels, cv::COLOR_GRAY2BGR);
  const double k = static_cast<double>(long_side_px) / std::max(pixels.cols, pixels.rows);
  if (k < 1) {
    const cv::Size size(std::max(1, cvRound(pixels.cols * k)), std::max(1, cvRound(pixels.rows * k)));
    cv::resize(pixels, pixels, size, 0, 0, cv::INTER_AREA);
  }
  return pixels;
}

}  // namespace yorb

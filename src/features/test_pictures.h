// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// For tests and benchmarks of the room.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "core/random.h"
#include "features/grey_image.h"

namespace yorb {

/// Grey rectangles, one over the other, under a little noise: many corners of all strengths.
inline cv::Mat RectanglesPicture(int width, int height, uint64_t seed, double noise = 3) {
  Random random(seed);
  cv::Mat picture(height, width, CV_8UC1, cv::Scalar(110));
  const int count = width * height / 700;
  for (int i = 0; i < count; ++i) {
    const cv::Point corner(static_cast<int>(random.Below(static_cast<uint32_t>(width))),
                           static_cast<int>(random.Below(static_cast<uint32_t>(height))));
    const cv::Size size(static_cast<int>(4 + random.Below(50)), static_cast<int>(4 + random.Below(50)));
    cv::rectangle(picture, cv::Rect(corner, size), cv::Scalar(random.Below(256)), cv::FILLED);
  }
  cv::GaussianBlur(picture, picture, cv::Size(3, 3), 0.7);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      uint8_t& pixel = picture.at<uint8_t>(y, x);
      pixel = cv::saturate_cast<uint8_t>(pixel + noise * random.Gaussian());
    }
  }
  return picture;
}

/// Every pixel is drawn anew: the hardest case for anything that must be equal to the bit.
inline cv::Mat NoisePicture(int width, int height, uint64_t seed) {
  Random random(seed);
  cv::Mat picture(height, width, CV_8UC1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) picture.at<uint8_t>(y, x) = static_cast<uint8_t>(random.Next() >> 56);
  }
  return picture;
}

/// The picture with the margin that the extractor reads beyond its edges.
inline GreyImage Padded(const cv::Mat& picture) {
  GreyImage image;
  image.Resize(picture.cols, picture.rows);
  for (int y = 0; y < picture.rows; ++y) std::copy_n(picture.ptr(y), picture.cols, image.Row(y));
  return image;
}

/// A folder of the real data set (YORB_DATA, or ../shared/data beside the checkout); empty when absent.
inline std::string DataFolder(const std::string& name) {
  const char* root = std::getenv("YORB_DATA");
  const std::filesystem::path folder =
      (root != nullptr ? std::filesystem::path(root)
                       : std::filesystem::path(__FILE__).parent_path() / "../../../shared/data") /
      name;
  std::error_code error;
  return std::filesystem::is_directory(folder, error) ? folder.lexically_normal().string() : "";
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/letterbox.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace yorb {

Letterbox FitLetterbox(const cv::Size& picture, const cv::Size& input) {
  const double scale =
      std::min(static_cast<double>(input.width) / picture.width, static_cast<double>(input.height) / picture.height);
  const auto scaled = [&](int size, int most) {
    return std::clamp(static_cast<int>(std::lround(size * scale)), 1, most);
  };
  Letterbox box{picture, input, {scaled(picture.width, input.width), scaled(picture.height, input.height)}};
  box.left = (input.width - box.scaled.width) / 2;
  box.top = (input.height - box.scaled.height) / 2;
  return box;
}

cv::Mat Letterboxed(const cv::Mat& picture, const Letterbox& box) {
  constexpr int kGrey = 114;  // the bars that YOLO networks are trained with
  if (box.scaled == box.picture && box.scaled == box.input) return picture;
  cv::Mat framed(box.input, picture.type(), cv::Scalar::all(kGrey));
  cv::Mat place = framed(cv::Rect({box.left, box.top}, box.scaled));
  // From half the size down pixels would be left out between the four that are mixed; means of areas cost more.
  const bool is_half = 2 * box.scaled.width <= box.picture.width;
  cv::resize(picture, place, box.scaled, 0, 0, is_half ? cv::INTER_AREA : cv::INTER_LINEAR);
  return framed;
}

}  // namespace yorb

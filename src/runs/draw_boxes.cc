// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/draw_boxes.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/text.h"
#include "detection/class_names.h"

namespace yorb {
namespace {

/// A bright colour that the name alone decides.
cv::Scalar ColourOf(const std::string& name) {
  uint32_t hash = 2166136261u;  // FNV-1a
  for (const char letter : FoldClassName(name)) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
  const uint32_t hue = (hash ^ hash >> 15) * 2654435761u >> 16;  // its upper bits, since short names differ little
  cv::Mat hsv(1, 1, CV_8UC3, cv::Scalar(hue * 180 >> 16, 190, 255)), bgr;
  cv::cvtColor(hsv, bgr, cv::COLOR_HSV2BGR);
  const auto pixel = bgr.at<cv::Vec3b>(0, 0);
  return {static_cast<double>(pixel[0]), static_cast<double>(pixel[1]), static_cast<double>(pixel[2])};
}

}  // namespace

cv::Mat DrawBoxes(const cv::Mat& picture, const std::vector<Box>& boxes) {
  cv::Mat drawn;
  if (picture.channels() == 1) {
    cv::cvtColor(picture, drawn, cv::COLOR_GRAY2BGR);
  } else {
    drawn = picture.clone();
  }
  const double size = std::max(0.4, drawn.cols / 1600.0);  // of the letters
  const int thickness = std::max(1, static_cast<int>(std::lround(drawn.cols / 400.0)));
  for (auto box = boxes.rbegin(); box != boxes.rend(); ++box) {  // the surest on top
    const cv::Scalar colour = ColourOf(box->name);
    const cv::Point corner(static_cast<int>(std::lround(box->left)), static_cast<int>(std::lround(box->top)));
    const cv::Point end(static_cast<int>(std::lround(box->right)) - 1, static_cast<int>(std::lround(box->bottom)) - 1);
    cv::rectangle(drawn, corner, end, colour, thickness);
    const std::string text = box->name + " " + FormatFixed(box->confidence, 2);
    int below = 0;
    const cv::Size letters = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, size, 1, &below);
    const cv::Point start(corner.x, std::max(corner.y, letters.height + below));
    cv::rectangle(drawn, start - cv::Point(0, letters.height + below), start + cv::Point(letters.width, 0), colour,
                  cv::FILLED);
    cv::putText(drawn, text, start - cv::Point(0, below / 2 + 1), cv::FONT_HERSHEY_SIMPLEX, size, cv::Scalar(0, 0, 0),
                1, cv::LINE_AA);
  }
  return drawn;
}

}  // namespace yorb

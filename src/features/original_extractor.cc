// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/original_extractor.h"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "features/descriptor.h"

namespace yorb {
namespace {

constexpr int kCellPx = 30, kRingPx = 3;

/// FAST in cells of about 30 px that overlap by the ring, at the first threshold and, where that finds nothing, at the
/// second.
std::vector<Corner> CornersByCells(const cv::Mat& level, int threshold, int threshold_low) {
  std::vector<Corner> corners;
  const int border = kFeatureBorder - kRingPx, width = level.cols - 2 * border, height = level.rows - 2 * border;
  const int columns = std::max(1, width / kCellPx), rows = std::max(1, height / kCellPx);
  const cv::Size cell((width + columns - 1) / columns, (height + rows - 1) / rows);
  for (int index = 0; index < rows * columns; ++index) {
    const cv::Point corner(border + index % columns * cell.width, border + index / columns * cell.height);
    const cv::Rect area = cv::Rect(corner, cv::Size(cell.width + 2 * kRingPx, cell.height + 2 * kRingPx)) &
                          cv::Rect(border, border, width, height);
    if (area.width <= 2 * kRingPx || area.height <= 2 * kRingPx) continue;
    std::vector<cv::KeyPoint> found;
    cv::FAST(level(area), found, threshold, true);
    if (found.empty()) cv::FAST(level(area), found, threshold_low, true);
    for (const cv::KeyPoint& point : found) {
      corners.push_back({static_cast<int>(point.pt.x) + area.x, static_cast<int>(point.pt.y) + area.y,
                         static_cast<int>(point.response), point.response, 0.f, 0.f});
    }
  }
  return corners;
}

GreyView ViewOf(const cv::Mat& grey) { return {grey.data, grey.cols, grey.rows, static_cast<ptrdiff_t>(grey.step[0])}; }

}  // namespace

void OriginalExtractor::AddLevel(const cv::Mat& level, int octave, int wanted, Features& features) {
  const CornerArea area{kFeatureBorder, kFeatureBorder, level.cols - kFeatureBorder, level.rows - kFeatureBorder};
  const std::vector<Corner>& corners =
      quadtree_.KeepBestOfEach(CornersByCells(level, options_.threshold, options_.threshold_low), area, wanted);
  if (corners.empty()) return;
  cv::Mat blurred;
  cv::GaussianBlur(level, blurred, {7, 7}, 2, 2, cv::BORDER_REFLECT_101);
  const GreyView sharp = ViewOf(level), soft = ViewOf(blurred);
  const float scale = static_cast<float>(std::pow(options_.scale_factor, octave));
  for (const Corner& corner : corners) {
    Keypoint keypoint;
    keypoint.x = static_cast<float>(corner.x) * scale;
    keypoint.y = static_cast<float>(corner.y) * scale;
    keypoint.angle_rad = OrientationOf(sharp, corner.x, corner.y, Instructions::kPortable);
    keypoint.response = corner.response;
    keypoint.octave = octave;
    features.keypoints.push_back(keypoint);
    features.descriptors.push_back(DescribeAt(soft, corner.x, corner.y, keypoint.angle_rad, Instructions::kPortable));
  }
}

Features OriginalExtractor::Extract(const cv::Mat& grey) {
  YORB_CHECK(grey.empty() || grey.type() == CV_8UC1, "the extractor takes 8-bit grey pictures");
  Features features;
  const double ratio = 1 / options_.scale_factor;
  double share = options_.wanted * (1 - ratio) / (1 - std::pow(ratio, options_.levels));
  int left = options_.wanted;
  cv::Mat level = grey;
  for (int octave = 0; octave < options_.levels; ++octave, share *= ratio) {
    if (octave > 0) {
      const double size = std::pow(ratio, octave);
      cv::Mat smaller;
      cv::resize(level, smaller, {cvRound(grey.cols * size), cvRound(grey.rows * size)}, 0, 0, cv::INTER_LINEAR);
      level = smaller;
    }
    if (level.cols <= 2 * kFeatureBorder || level.rows <= 2 * kFeatureBorder) break;
    const int wanted = octave + 1 < options_.levels ? cvRound(share) : left;
    left = std::max(0, left - wanted);
    AddLevel(level, octave, wanted, features);
  }
  return features;
}

}  // namespace yorb

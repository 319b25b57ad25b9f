// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/line_segments.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace yorb {
namespace {

bool IsUnder(const cv::Mat& hidden, const Eigen::Vector2f& px) {
  const int x = std::clamp(cvRound(px.x()), 0, hidden.cols - 1), y = std::clamp(cvRound(px.y()), 0, hidden.rows - 1);
  return hidden.at<uint8_t>(y, x) != 0;
}

}  // namespace

std::vector<LineSegment> FindLineSegments(const cv::Mat& grey, const cv::Mat& hidden) {
  constexpr double kWorkingWidth = 320, kMostScale = 0.8;  // LSD's own scale, against steps of single pixels
  constexpr float kLeastShare = 0.05f;                     // of the width
  std::vector<LineSegment> segments;
  if (grey.empty()) return segments;
  const double scale = std::min(kMostScale, kWorkingWidth / grey.cols);
  std::vector<cv::Vec4f> found;
  cv::createLineSegmentDetector(cv::LSD_REFINE_STD, scale)->detect(grey, found);
  const float least_px = kLeastShare * static_cast<float>(grey.cols);
  for (const cv::Vec4f& ends : found) {
    const LineSegment segment{{ends[0], ends[1]}, {ends[2], ends[3]}};
    if ((segment.to_px - segment.from_px).norm() < least_px) continue;
    const bool is_hidden = !hidden.empty() && (IsUnder(hidden, segment.from_px) || IsUnder(hidden, segment.to_px) ||
                                               IsUnder(hidden, 0.5f * (segment.from_px + segment.to_px)));
    if (!is_hidden) segments.push_back(segment);
  }
  return segments;
}

}  // namespace yorb

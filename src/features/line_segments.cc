// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/line_segments.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "camera/mask.h"

namespace yorb {
namespace {

/// The pixel of a picture at a place, or the nearest to it.
cv::Point PixelAt(const Eigen::Vector2f& px, const cv::Size& size) {
  return {std::clamp(cvRound(px.x()), 0, size.width - 1), std::clamp(cvRound(px.y()), 0, size.height - 1)};
}

}  // namespace

std::vector<LineSegment> FindLineSegments(const cv::Mat& grey, const cv::Mat& hidden) {
  constexpr int kWorkingWidth = 300;
  constexpr float kLeastShare = 0.05f;  // of the width
  std::vector<LineSegment> segments;
  if (grey.empty()) return segments;
  const double shrink = std::min(1.0, static_cast<double>(kWorkingWidth) / grey.cols);
  const cv::Size size(cvRound(shrink * grey.cols), std::max(1, cvRound(shrink * grey.rows)));
  cv::Mat small = grey;
  if (size != grey.size()) cv::resize(grey, small, size, 0, 0, cv::INTER_AREA);
  std::vector<cv::Vec4f> found;
  cv::createLineSegmentDetector()->detect(small, found);

  const Eigen::Array2f scale(static_cast<float>(grey.cols) / static_cast<float>(size.width),
                             static_cast<float>(grey.rows) / static_cast<float>(size.height));
  const auto full_px = [&](float x, float y) -> Eigen::Vector2f {
    return (Eigen::Array2f(x, y) + 0.5f) * scale - 0.5f;  // (0, 0) is the centre of a pixel
  };
  const float least_px = kLeastShare * static_cast<float>(grey.cols);
  for (const cv::Vec4f& ends : found) {
    const LineSegment segment{full_px(ends[0], ends[1]), full_px(ends[2], ends[3])};
    if ((segment.to_px - segment.from_px).norm() < least_px) continue;
    const auto is_hidden = [&](const Eigen::Vector2f& px) {
      return IsMarked(hidden, PixelAt(px, grey.size()), grey.size());
    };
    const Eigen::Vector2f middle_px = 0.5f * (segment.from_px + segment.to_px);
    if (!is_hidden(segment.from_px) && !is_hidden(segment.to_px) && !is_hidden(middle_px)) segments.push_back(segment);
  }
  return segments;
}

}  // namespace yorb

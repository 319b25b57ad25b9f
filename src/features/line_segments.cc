// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/line_segments.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace yorb {
namespace {

/// Whether a place of a picture lies in a cell that is hidden.
bool IsUnder(const cv::Mat& hidden, const cv::Size& picture, const Eigen::Vector2f& px) {
  const auto cell = [](float at, int pixels, int cells) {
    const float cells_a_pixel = static_cast<float>(cells) / static_cast<float>(pixels);
    return std::clamp(static_cast<int>((at + 0.5f) * cells_a_pixel), 0, cells - 1);
  };
  return hidden.at<uint8_t>(cell(px.y(), picture.height, hidden.rows), cell(px.x(), picture.width, hidden.cols)) != 0;
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
    const Eigen::Vector2f middle_px = 0.5f * (segment.from_px + segment.to_px);
    const bool is_hidden =
        !hidden.empty() && (IsUnder(hidden, grey.size(), segment.from_px) ||
                            IsUnder(hidden, grey.size(), segment.to_px) || IsUnder(hidden, grey.size(), middle_px));
    if (!is_hidden) segments.push_back(segment);
  }
  return segments;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/line_segments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace yorb {
namespace {

/// A bright field with a dark quadrangle, drawn without steps.
cv::Mat Quadrangle(const std::vector<cv::Point>& corners) {
  cv::Mat grey(480, 640, CV_8UC1, cv::Scalar(200));
  cv::fillConvexPoly(grey, corners, cv::Scalar(60), cv::LINE_AA);
  return grey;
}

/// How far off the nearest segment is of those that run along a side, in degrees; 90 where none does.
double OffDeg(const std::vector<LineSegment>& segments, const cv::Point& a, const cv::Point& b) {
  const Eigen::Vector2f from(static_cast<float>(a.x), static_cast<float>(a.y));
  const Eigen::Vector2f side = Eigen::Vector2f(static_cast<float>(b.x), static_cast<float>(b.y)) - from;
  double best = 90;
  for (const LineSegment& segment : segments) {
    const Eigen::Vector2f along = segment.to_px - segment.from_px, to_middle = segment.from_px + 0.5f * along - from;
    const auto cross = [](const Eigen::Vector2f& p, const Eigen::Vector2f& q) { return p.x() * q.y() - p.y() * q.x(); };
    if (std::abs(cross(side, to_middle)) / side.norm() > 2 || along.norm() < 0.7f * side.norm()) continue;
    best = std::min(best, std::asin(std::abs(double{cross(side, along)}) / (side.norm() * along.norm())) * 180 / M_PI);
  }
  return best;
}

const std::vector<cv::Point> kCorners = {{150, 100}, {480, 130}, {450, 390}, {180, 350}};

TEST(FindLineSegments, FindsTheSidesOfAQuadrangle) {
  const auto segments = FindLineSegments(Quadrangle(kCorners));
  for (size_t k = 0; k < 4; ++k) EXPECT_LT(OffDeg(segments, kCorners[k], kCorners[(k + 1) % 4]), 0.3) << k;
}

TEST(FindLineSegments, LeavesOutWhatIsHiddenAndWhatIsShort) {
  for (const int cell_px : {1, 8}) {
    cv::Mat hidden(480 / cell_px, 640 / cell_px, CV_8UC1, cv::Scalar(0));
    hidden.rowRange(0, 200 / cell_px).setTo(1);  // the upper side, and an end of those beside it
    const auto segments = FindLineSegments(Quadrangle(kCorners), hidden);
    EXPECT_EQ(OffDeg(segments, kCorners[0], kCorners[1]), 90) << cell_px;
    EXPECT_EQ(OffDeg(segments, kCorners[1], kCorners[2]), 90) << cell_px;
    EXPECT_LT(OffDeg(segments, kCorners[2], kCorners[3]), 0.3) << cell_px;
  }
  EXPECT_TRUE(FindLineSegments(Quadrangle({{300, 200}, {320, 200}, {320, 220}, {300, 220}})).empty());
}

TEST(FindLineSegments, FindsNothingInNothing) {
  EXPECT_TRUE(FindLineSegments(cv::Mat()).empty());
  EXPECT_TRUE(FindLineSegments(cv::Mat(1, 1, CV_8UC1, cv::Scalar(7))).empty());
  EXPECT_TRUE(FindLineSegments(cv::Mat(480, 640, CV_8UC1, cv::Scalar(7))).empty());
}

}  // namespace
}  // namespace yorb

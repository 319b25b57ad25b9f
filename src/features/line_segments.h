// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

namespace yorb {

/// A straight edge of a picture, from end to end in real pixels.
struct LineSegment {
  Eigen::Vector2f from_px, to_px;
};

/// The straight edges of a picture (CV_8UC1) that are long enough, a twentieth of its width, to say which way they run:
/// OpenCV's detector after Grompone von Gioi et al., "LSD: A Fast Line Segment Detector with a False Detection
/// Control", 2010, on the picture reduced to 300 pixels' width: three times as fast, and nearly as exact for
/// directions. Edges with an end or the middle under `hidden` (CV_8UC1, non-zero; may be empty, or have fewer pixels:
/// it lies over the whole picture) are left out.
std::vector<LineSegment> FindLineSegments(const cv::Mat& grey, const cv::Mat& hidden = {});

}  // namespace yorb

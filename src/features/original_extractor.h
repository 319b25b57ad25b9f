// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "features/keypoint.h"
#include "features/quadtree.h"

namespace yorb {

/// The extractor that the paper improves, stage by stage as ORB-SLAM2 has it and with OpenCV's parts: FAST cell by cell
/// at two fixed thresholds, the full quadtree, a blur for each level, one descriptor after the other. It stands here to
/// be measured against; OrbExtractor with `detector: fixed` and `distribution: quadtree` finds much the same points in
/// a fraction of the time.
class OriginalExtractor {
 public:
  /// Points a picture and grey levels.
  struct Options {
    int wanted = 1000;
    int levels = 8;
    double scale_factor = 1.2;
    int threshold = 20, threshold_low = 7;
  };

  explicit OriginalExtractor(const Options& options) : options_(options) {}

  /// `grey` is CV_8UC1.
  Features Extract(const cv::Mat& grey);

 private:
  void AddLevel(const cv::Mat& level, int octave, int wanted, Features& features);

  Options options_;
  Quadtree quadtree_;
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "features/orb_extractor.h"

namespace yorb {

/// Names of the front ends that are compared, as the JSON has them.
namespace front_end {
inline const std::string kImproved = "improved";             ///< ours
inline const std::string kOriginal = "original";             ///< thresholds of ORB-SLAM2: 20 and 7; full quadtree
inline const std::string kOriginalPaper = "original_40_30";  ///< the same with the paper's thresholds
inline const std::string kOriginalPath = "original_path";    ///< 20 and 7 in the very way of ORB-SLAM2: for times
inline const std::string kCvOrb = "cv_orb";                  ///< cv::ORB::create with as many points
inline const std::string kCvFast = "cv_fast";                ///< cv::FAST at 20: counts of corners only
}  // namespace front_end

/// One way to get features from a picture (CV_8UC1).
struct FrontEnd {
  std::string name;
  std::function<Features(const cv::Mat&)> extract;
};

/// All ways that give features; `ours` says how many points and levels they all have.
std::vector<FrontEnd> FrontEnds(const FeatureOptions& ours);

/// `ours` with the original detector at these thresholds and the original distribution.
FeatureOptions OriginalOptions(const FeatureOptions& ours, int threshold, int threshold_low);

/// A way to count corners before they are thinned out, over all levels of the pyramid or on the picture alone.
struct CornerCounter {
  std::string name;
  std::function<size_t(const cv::Mat&)> count;
};

/// Corners of the first threshold after non-maximum suppression, over all levels: the original at 40 (kOriginal), ours
/// (kImproved), and cv::FAST at 20 (kCvFast).
std::vector<CornerCounter> CornerCounters(const FeatureOptions& ours);

}  // namespace yorb

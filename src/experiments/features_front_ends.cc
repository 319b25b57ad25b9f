// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/features_front_ends.h"

#include <cstring>
#include <memory>
#include <opencv2/features2d.hpp>

#include "features/original_extractor.h"
#include "features/pyramid.h"

namespace yorb {
namespace {

constexpr int kPaperThreshold = 40, kPaperThresholdLow = 30;
constexpr int kOrbSlamThreshold = 20, kOrbSlamThresholdLow = 7;
constexpr float kRadiansPerDegree = 0.0174532925f;

FrontEnd Ours(const std::string& name, const FeatureOptions& options) {
  const auto extractor = std::make_shared<OrbExtractor>(options);
  return {name, [extractor](const cv::Mat& grey) { return extractor->Extract(grey); }};
}

FrontEnd OriginalPath(const FeatureOptions& ours) {
  const auto extractor = std::make_shared<OriginalExtractor>(
      OriginalExtractor::Options{ours.wanted, ours.levels, ours.scale_factor, kOrbSlamThreshold, kOrbSlamThresholdLow});
  return {front_end::kOriginalPath, [extractor](const cv::Mat& grey) { return extractor->Extract(grey); }};
}

FrontEnd CvOrb(const FeatureOptions& ours) {
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(ours.wanted, static_cast<float>(ours.scale_factor), ours.levels);
  return {front_end::kCvOrb, [orb](const cv::Mat& grey) {
            std::vector<cv::KeyPoint> points;
            cv::Mat rows;
            orb->detectAndCompute(grey, cv::noArray(), points, rows);
            Features features;
            features.descriptors.resize(points.size());
            for (size_t i = 0; i < points.size(); ++i) {
              const cv::KeyPoint& p = points[i];
              features.keypoints.push_back({p.pt.x, p.pt.y, p.angle * kRadiansPerDegree, p.response, p.octave});
              std::memcpy(&features.descriptors[i], rows.ptr(static_cast<int>(i)), sizeof(Descriptor));
            }
            return features;
          }};
}

using LevelCounter = std::function<size_t(const GreyView&)>;

/// The sum of `count` over all levels.
CornerCounter OverLevels(const std::string& name, const FeatureOptions& options, const LevelCounter& count) {
  const auto pyramid = std::make_shared<Pyramid>();
  return {name, [=](const cv::Mat& grey) {
            const GreyView picture{grey.data, grey.cols, grey.rows, static_cast<ptrdiff_t>(grey.step[0])};
            pyramid->Build(picture, options.levels, options.scale_factor, BestInstructions());
            size_t sum = 0;
            for (int level = 0; level < pyramid->levels(); ++level) sum += count(pyramid->Level(level));
            return sum;
          }};
}

CornerCounter FirstCorners(const std::string& name, const FeatureOptions& options) {
  const auto detector = std::make_shared<CornerDetector>();
  const CornerOptions corners = CornersOf(options);
  return OverLevels(name, options, [=](const GreyView& level) {
    return detector->DetectFirst(level, corners, BestInstructions()).size();
  });
}

size_t CvFastCorners(const GreyView& level) {
  if (level.empty()) return 0;
  const cv::Mat pixels(level.height, level.width, CV_8UC1, const_cast<uint8_t*>(level.pixels),
                       static_cast<size_t>(level.stride));
  std::vector<cv::KeyPoint> found;
  cv::FAST(pixels, found, kOrbSlamThreshold, true);
  return found.size();
}

}  // namespace

FeatureOptions OriginalOptions(const FeatureOptions& ours, int threshold, int threshold_low) {
  FeatureOptions original;
  original.wanted = ours.wanted;
  original.over_extraction = ours.over_extraction;
  original.levels = ours.levels;
  original.scale_factor = ours.scale_factor;
  original.detector = "fixed";
  original.subpixel = false;
  original.distribution = "quadtree";
  original.fixed_threshold = threshold;
  original.fixed_threshold_low = threshold_low;
  return original;
}

std::vector<FrontEnd> FrontEnds(const FeatureOptions& ours) {
  return {Ours(front_end::kImproved, ours),
          Ours(front_end::kOriginal, OriginalOptions(ours, kOrbSlamThreshold, kOrbSlamThresholdLow)),
          Ours(front_end::kOriginalPaper, OriginalOptions(ours, kPaperThreshold, kPaperThresholdLow)),
          OriginalPath(ours), CvOrb(ours)};
}

std::vector<CornerCounter> CornerCounters(const FeatureOptions& ours) {
  return {FirstCorners(front_end::kImproved, ours),
          FirstCorners(front_end::kOriginal, OriginalOptions(ours, kPaperThreshold, kPaperThresholdLow)),
          OverLevels(front_end::kCvFast, ours, CvFastCorners)};
}

}  // namespace yorb

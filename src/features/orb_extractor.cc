// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/orb_extractor.h"

#include <cmath>
#include <optional>

#include "core/check.h"
#include "features/blur.h"
#include "features/descriptor.h"
#include "features/pyramid.h"
#include "features/quadtree.h"

namespace yorb {
namespace {

/// How many corners each level gives: in geometric proportion, as the sides of the levels; their sum is the total.
std::vector<int> SharesOf(const FeatureOptions& options) {
  const int total = static_cast<int>(std::lround(options.wanted * options.over_extraction));
  const double ratio = 1 / options.scale_factor;
  double share = total * (1 - ratio) / (1 - std::pow(ratio, options.levels));
  std::vector<int> shares;
  int left = total;
  for (int level = 0; level + 1 < options.levels; ++level, share *= ratio) {
    shares.push_back(static_cast<int>(std::lround(share)));
    left -= shares.back();
  }
  shares.push_back(std::max(left, 0));
  return shares;
}

}  // namespace

CornerOptions CornersOf(const FeatureOptions& options) {
  CornerOptions corners;
  corners.is_adaptive = options.detector == "adaptive";
  corners.high = options.fixed_threshold;
  corners.low = options.fixed_threshold_low;
  corners.alpha = options.alpha;
  corners.alpha_low = options.alpha_low;
  corners.choice = options.choice;
  corners.noise = options.noise_threshold;
  corners.arc = options.fast_arc;
  corners.border = kFeatureBorder;
  return corners;
}

/// What stays from frame to frame, so that nothing is allocated anew.
struct OrbExtractor::Scratch {
  Instructions instructions = BestInstructions();
  std::vector<int> shares;
  CornerOptions corner_options;
  Pyramid pyramid;
  Quadtree quadtree;

  /// What is known of a level until the next picture comes.
  struct Level {
    CornerDetector detector;
    Blur blur;
    std::optional<GreyView> blurred;
  };
  std::vector<Level> levels;

  /// Where a corner of a level lies in the picture. Centres of pixels are whole numbers, and the levels share their
  /// borders, not their first centres: scaling the bare coordinate would shift the points of level l by
  /// (scale - 1) / 2 px, 1.3 px on the eighth.
  Keypoint PlaceOf(const Corner& corner, int octave) const {
    const GreyView &picture = pyramid.Level(0), &level = pyramid.Level(octave);
    const float x_scale = static_cast<float>(picture.width) / static_cast<float>(level.width);
    const float y_scale = static_cast<float>(picture.height) / static_cast<float>(level.height);
    Keypoint keypoint;
    keypoint.x = (static_cast<float>(corner.x) + corner.dx + 0.5f) * x_scale - 0.5f;
    keypoint.y = (static_cast<float>(corner.y) + corner.dy + 0.5f) * y_scale - 0.5f;
    keypoint.octave = octave;
    return keypoint;
  }

  const std::vector<Corner>& CornersOfLevel(const FeatureOptions& options, int octave, const PointFilter& may_use,
                                            bool is_again) {
    const GreyView& level = pyramid.Level(octave);
    const int wanted = shares[static_cast<size_t>(octave)];
    CornerFilter filter;
    if (may_use) filter = [&](const Corner& corner) { return may_use(PlaceOf(corner, octave)); };
    CornerDetector& detector = levels[static_cast<size_t>(octave)].detector;
    const std::vector<Corner>& found = is_again
                                           ? detector.DetectAgain(level, corner_options, wanted, instructions, filter)
                                           : detector.Detect(level, corner_options, wanted, instructions, filter);
    const int border = corner_options.border;
    const CornerArea area{border, border, level.width - border, level.height - border};
    return options.distribution == "quadtree" ? quadtree.KeepBestOfEach(found, area, wanted)
                                              : quadtree.KeepSinglesAndBest(found, area, wanted);
  }

  void AddLevel(const FeatureOptions& options, const std::vector<Corner>& corners, int octave, Features& features) {
    if (corners.empty()) return;
    const GreyView& level = pyramid.Level(octave);
    Level& known = levels[static_cast<size_t>(octave)];
    if (!known.blurred) known.blurred = known.blur.Apply(level, instructions);
    for (Corner corner : corners) {
      if (options.subpixel) corner = Refined(corner);
      Keypoint keypoint = PlaceOf(corner, octave);
      keypoint.angle_rad = OrientationOf(level, corner.x, corner.y, instructions);
      keypoint.response = corner.response;
      features.keypoints.push_back(keypoint);
      features.descriptors.push_back(DescribeAt(*known.blurred, corner.x, corner.y, keypoint.angle_rad, instructions));
    }
  }
};

OrbExtractor::OrbExtractor(const FeatureOptions& options) : options_(options), scratch_(std::make_unique<Scratch>()) {
  scratch_->shares = SharesOf(options);
  scratch_->corner_options = CornersOf(options);
  scratch_->levels.resize(static_cast<size_t>(options.levels));
}
OrbExtractor::~OrbExtractor() = default;
OrbExtractor::OrbExtractor(OrbExtractor&&) noexcept = default;
OrbExtractor& OrbExtractor::operator=(OrbExtractor&&) noexcept = default;

Features OrbExtractor::Extract(const cv::Mat& grey, const PointFilter& may_use) {
  YORB_CHECK(grey.empty() || grey.type() == CV_8UC1, "the extractor takes 8-bit grey pictures");
  const GreyView picture{grey.data, grey.cols, grey.rows, static_cast<ptrdiff_t>(grey.step[0])};
  scratch_->pyramid.Build(picture, options_.levels, options_.scale_factor, scratch_->instructions);
  for (Scratch::Level& level : scratch_->levels) level.blurred.reset();
  return ExtractLevels(may_use, false);
}

Features OrbExtractor::ExtractAgain(const PointFilter& may_use) {
  YORB_CHECK(scratch_->pyramid.levels() > 0, "there must have been a picture before");
  return ExtractLevels(may_use, true);
}

Features OrbExtractor::ExtractLevels(const PointFilter& may_use, bool is_again) {
  Features features;
  const size_t total = static_cast<size_t>(std::lround(options_.wanted * options_.over_extraction));
  features.keypoints.reserve(total);
  features.descriptors.reserve(total);
  for (int octave = 0; octave < options_.levels; ++octave) {
    const GreyView& level = scratch_->pyramid.Level(octave);
    if (level.width <= 2 * kFeatureBorder || level.height <= 2 * kFeatureBorder) break;
    scratch_->AddLevel(options_, scratch_->CornersOfLevel(options_, octave, may_use, is_again), octave, features);
  }
  return features;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: features. From a picture to a Frame.
// Takes: grey pictures, depth, Rig. Gives: Features, Frame (const from then on). Owns: its scratch buffers.
// Runs on: one thread at a time for each extractor. May not: know poses or maps.
#pragma once

#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <string>

#include "core/options.h"
#include "features/adaptive_fast.h"
#include "features/keypoint.h"

namespace yorb {

/// Options of the ORB extractor; YAML group `features`. With `choice` the adaptive detector's candidates are the
/// corners that are the strongest for their neighbourhood and pass the second threshold; without, the first threshold
/// decides cell by cell, and the second where a cell finds nothing, as in the paper.
struct FeatureOptions {
  int wanted = 1000;                      ///< points a picture that tracking gets
  double over_extraction = 1.5;           ///< how many times `wanted` is extracted where moving points are removed
  std::string trim = "response";          ///< what stays of more than wanted: the strongest, or spread over the picture
  int levels = 8;                         ///< of the pyramid
  double scale_factor = 1.2;              ///< between levels
  std::string detector = "adaptive";      ///< fixed: ORB-SLAM2's thresholds; adaptive: equation (3) of the paper
  std::string distribution = "improved";  ///< quadtree: ORB-SLAM2's; improved: equation (4) of the paper
  int fast_arc = 9;                       ///< contiguous ring pixels that make a corner: 12 (the paper) or 9 (ORB)
  int fixed_threshold = 20;               ///< grey levels; detector fixed
  int fixed_threshold_low = 7;            ///< grey levels, where a cell finds nothing; detector fixed
  double alpha = 0.7;                     ///< of equation (3); detector adaptive
  double alpha_low = 0.07;                ///< of the second threshold, where a cell finds nothing; detector adaptive
  int noise_threshold = 4;                ///< grey levels every corner must exceed; detector adaptive
  double choice = 2;                      ///< candidates for each wanted point; 0: cell by cell; detector adaptive
  bool subpixel = true;                   ///< refines the place of a corner by a parabola through the scores around it

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("wanted", self.wanted, Range(50, 20000));
    visit("over_extraction", self.over_extraction, Range(1, 5));
    visit("trim", self.trim, OneOf({"response", "spread"}));
    visit("levels", self.levels, Range(1, 12));
    visit("scale_factor", self.scale_factor, Range(1.05, 2));
    visit("detector", self.detector, OneOf({"fixed", "adaptive"}));
    visit("distribution", self.distribution, OneOf({"quadtree", "improved"}));
    visit("fast_arc", self.fast_arc, OneOf({"9", "12"}));
    visit("fixed_threshold", self.fixed_threshold, Range(1, 254));
    visit("fixed_threshold_low", self.fixed_threshold_low, Range(1, 254));
    visit("alpha", self.alpha, Range(0.01, 5));
    visit("alpha_low", self.alpha_low, Range(0, 5));
    visit("noise_threshold", self.noise_threshold, Range(1, 254));
    visit("choice", self.choice, Range(0, 20));
    visit("subpixel", self.subpixel, AnyValue());
  }
};

/// How these options choose the corners of a level.
CornerOptions CornersOf(const FeatureOptions& options);

/// Whether a point may be used, by its place (px) and octave alone; empty: all may.
using PointFilter = std::function<bool(const Keypoint&)>;

/// Finds oriented FAST corners over a pyramid, spreads them over the picture and describes them.
/// Deterministic: the same picture gives the same features, whatever came before.
class OrbExtractor {
 public:
  explicit OrbExtractor(const FeatureOptions& options);
  ~OrbExtractor();
  OrbExtractor(OrbExtractor&&) noexcept;
  OrbExtractor& operator=(OrbExtractor&&) noexcept;

  /// `grey` is CV_8UC1 of any size; a picture too small for a level gives no points there. Where `may_use` is given,
  /// points that it refuses are left out before they are counted and spread: the others take their places.
  Features Extract(const cv::Mat& grey, const PointFilter& may_use = {});

  /// What `Extract` would give for the picture of the last call, which must still be there, with another filter. Much
  /// of the work is done already.
  Features ExtractAgain(const PointFilter& may_use);

 private:
  Features ExtractLevels(const PointFilter& may_use, bool is_again);

  struct Scratch;
  FeatureOptions options_;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: dynamics. Says which points are on moving things, before the pose is known.
// Takes: ImageSet, Detections. Gives: MovingAreas, a verdict a point. Owns: the boxes that it follows.
// Runs on: one thread at a time. May not: know poses or maps, run detectors, cut features.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "camera/image_set.h"
#include "detection/detector.h"
#include "dynamics/body.h"
#include "dynamics/box_tracks.h"
#include "dynamics/removal_rules.h"

namespace yorb {

/// What is done about moving things.
enum class Dynamics {
  kOff,    ///< nothing: only the user's own masks count
  kPaper,  ///< the paper's rules, box by box
  kFull,   ///< boxes followed over time; within them, depth tells the body from the background
};

/// What of one picture moves.
class MovingAreas {
 public:
  /// Decides about a point, by its place and octave.
  Verdict Judge(const Keypoint& point) const;
  std::vector<Verdict> Judge(const std::vector<Keypoint>& points) const;
  /// Whether the user's own mask lies under a point.
  bool Ignores(const Keypoint& point) const;

  /// The boxes of things that move by themselves.
  const std::vector<Box>& boxes() const { return boxes_; }
  /// How many of them were not seen in this very picture.
  int num_bridged() const { return num_bridged_; }
  /// CV_8UC1, a pixel a cell of depth: not 0 on moving bodies; empty where only boxes count.
  const cv::Mat& bodies() const { return bodies_; }
  /// CV_8UC1, a pixel a cell of pictures of `size`: not 0 where no wall or floor is measured: on bodies; where
  /// only boxes count, in those, as points in them are judged; under the user's masks. Empty: nowhere.
  cv::Mat Covered(const cv::Size& size) const;

 private:
  friend class Remover;

  BoxRules rules_{{}};
  std::vector<Box> boxes_;
  int num_bridged_ = 0;
  cv::Mat bodies_, ignored_;
  double scale_factor_ = 1;
};

/// The features for whose index `is_kept` holds, in their order.
Features Kept(Features features, const std::function<bool(size_t)>& is_kept);

/// Finds what moves in one picture after the other.
class Remover {
 public:
  /// `scale_factor`: of the pyramid that the points come from. `sure_confidence`: weaker boxes count only where they
  /// go on from stronger ones.
  Remover(Dynamics dynamics, MotionTable table, double scale_factor, double sure_confidence = 0);

  /// Does of a picture's work what needs no boxes, while somebody else looks for them. May be left out.
  void Prepare(const ImageSet& images);

  /// Pictures come in the order of time.
  MovingAreas Look(const ImageSet& images, const SeenAt& looked);

 private:
  /// What a depth picture shows by itself.
  struct Ground {
    Timestamp at;
    DepthCells depth;
    CellMask lying;  ///< desks and floors
  };

  void FollowBodies(const ImageSet& images, const SeenAt& looked, MovingAreas& areas);

  Dynamics dynamics_;
  MotionTable table_;
  double scale_factor_;
  BoxTracks tracks_;
  std::optional<Ground> ground_;  ///< of the newest picture, once it is prepared
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/random.h"
#include "features/frame.h"
#include "geometry/rigid3.h"

namespace yorb {

/// How a synthetic world is made and seen.
struct SyntheticWorldOptions {
  int num_points = 5000;
  double pixel_noise = 0;   ///< standard deviation at octave 0, pixels
  double flipped_bits = 8;  ///< of each descriptor at each look, on average
  double depth_share = 1;   ///< of the keypoints that have depth
  double depth_noise = 0;   ///< standard deviation of the right coordinate, pixels
};

/// Points on the walls of a room, without pictures: frames with exact truth for the tests of matching, tracking and
/// mapping. The room is 6 m wide, 3 m high and 6 m deep, with the origin in its middle, 2 m before the back wall.
class SyntheticWorld {
 public:
  explicit SyntheticWorld(uint64_t seed, const SyntheticWorldOptions& options = {});

  /// What a camera there sees, and which point each keypoint shows.
  struct View {
    FramePtr frame;
    std::vector<uint32_t> points;  ///< a row a keypoint
  };
  View Look(const Rigid3& cam_from_world, FrameId id, Timestamp time) const;

  const Eigen::Vector3d& Position(uint32_t point) const { return points_[point].x_in_world; }
  const Rig& rig() const { return *rig_; }

 private:
  struct Point {
    Eigen::Vector3d x_in_world;
    Descriptor descriptor;
    double size = 1;  ///< the distance at which it is a corner of octave 0
  };

  SyntheticWorldOptions options_;
  uint64_t seed_;
  std::shared_ptr<const Rig> rig_;
  std::shared_ptr<const ScaleTable> scales_;
  std::vector<Point> points_;
};

}  // namespace yorb

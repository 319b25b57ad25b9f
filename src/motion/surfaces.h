// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <vector>

#include "motion/past_views.h"
#include "optimize/pose.h"

namespace yorb {

/// The surfaces that depth pictures of the last seconds showed. Where few points are left for a pose, walls and floors
/// say where the camera is: the next depth picture has to lie on them (point-to-plane alignment, Chen and Medioni
/// 1992).
class Surfaces {
 public:
  /// Takes in the newest picture; of those before some in a second are kept.
  void Add(const DepthGrid& grid, Timestamp at, const CameraPlace& place);

  /// Points of a depth picture and the planes of earlier ones that they should lie on, as seen from about
  /// `cam_from_world`. The errors of a depth picture go together: all pairs weigh no more than kMostWeight single ones.
  std::vector<PlaneObservation> Pair(const DepthGrid& grid, const Rig& rig, const Rigid3& cam_from_world,
                                     const Map& map) const;

  void Forget() { views_.clear(); }

  static constexpr double kMostWeight = 600;

 private:
  std::deque<DepthView> views_;  ///< in the order of time
};

}  // namespace yorb

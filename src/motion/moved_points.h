// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "features/frame.h"
#include "motion/past_views.h"

namespace yorb {

/// A frame whose pose is known.
struct PosedFrame {
  FramePtr frame;
  std::vector<bool> is_known;  ///< a row a keypoint: whether it shows a landmark in its place
  CameraPlace place;
};

/// Keypoints of `now` that were elsewhere in the world in `then`: points that no landmark explains, alike in both
/// frames, of which several near each other went the same way by more than the sensor's noise. One outlier is no mover.
std::vector<uint32_t> FindMovedPoints(const PosedFrame& then, const PosedFrame& now, const Rigid3& now_from_then);

}  // namespace yorb

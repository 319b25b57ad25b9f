// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "features/frame.h"
#include "optimize/observation.h"

namespace yorb {

/// The observation that a keypoint of a frame makes.
inline Observation Observed(const Frame& frame, size_t index) {
  Observation seen;
  seen.x_px = frame.points_px[index].x();
  seen.y_px = frame.points_px[index].y();
  seen.right_px = frame.right_px[index];
  seen.inverse_variance = frame.InverseVariance(index);
  return seen;
}

}  // namespace yorb

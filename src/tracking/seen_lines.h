// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "features/frame.h"
#include "geometry/line_sight.h"
#include "tracking/motion_model.h"
#include "tracking/sight.h"

namespace yorb {

/// The straight edges of a picture, as a camera with all rows at once would have seen them (as WithoutShutter does with
/// points, at DepthOfOthers).
LineSightsPtr SeeLines(const Sight& sight, const Frame& frame, const std::optional<CameraRate>& rate);

}  // namespace yorb

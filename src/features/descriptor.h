// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "features/grey_image.h"
#include "features/instructions.h"
#include "features/keypoint.h"

namespace yorb {

/// A keypoint must be so far inside of its level: room for the rotated pattern (18 px) and one to spare.
constexpr int kFeatureBorder = 19;

/// Where the intensity centroid of the round 31 px patch about (x, y) lies, in radians in [0, 2 pi). Of the level as it
/// is, not blurred. The very number of cv::ORB: its degrees times float(pi / 180).
float OrientationOf(const GreyView& level, int x, int y, Instructions instructions);

/// The 256 tests of rotated BRIEF about (x, y) of a blurred level.
Descriptor DescribeAt(const GreyView& blurred, int x, int y, float angle_rad, Instructions instructions);

}  // namespace yorb

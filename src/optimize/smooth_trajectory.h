// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/time.h"
#include "geometry/rigid3.h"

namespace yorb {

/// A pose as one picture gave it, and how well its points hold it.
struct MeasuredPose {
  Timestamp timestamp;
  Rigid3 cam_from_world;
  /// J^T W J of the picture's points, in pixels, for the step of Rigid3::FromStep; zero where none holds the pose.
  Matrix6d information = Matrix6d::Zero();
};

/// The likeliest path of a camera that was seen at these poses, in the order of their time, and that hands or wheels
/// move: the poses that are nearest to the measured ones and to a motion whose acceleration is white noise of the size
/// of `geometry/usual_motion` (the prior of Anderson and Barfoot, "Full STEAM ahead", IROS 2015). Where many points
/// hold a pose this takes out the trembling of a few millimetres; where few do, poses before and after bridge the gap.
///
/// A pose is worth less than its points say if each errs by itself, for all of them lie in one map. After a pause
/// nothing is known of the motion: the path falls into pieces there that know nothing of one another. Where a camera is
/// quicker than hands are, or the stamps are wrong, so that the path would leave what was measured, more acceleration
/// is allowed until it does not.
std::vector<Rigid3> SmoothTrajectory(const std::vector<MeasuredPose>& measured);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "features/frame.h"
#include "tracking/motion_model.h"

namespace yorb {

/// How the camera moved from the middle row of a picture to the one at `y_px`, real pixels.
Rigid3 MotionToRow(const Rig& rig, const CameraRate& rate, double y_px);

/// A point at `depth` metres on an ideal pixel that was read in the row at `y_px`, real pixels, as the camera had it
/// when the middle row was read.
Eigen::Vector3d WhenMiddleRowWasRead(const Rig& rig, const CameraRate& rate, const Eigen::Vector2f& ideal_px,
                                     double y_px, double depth);

/// The depth that is taken for a point without one: the median of the others, or far away, where only the turn counts.
float DepthOfOthers(const Frame& frame);

/// The frame as a camera with all rows at once would have seen it when the middle row was read, where `rig.readout_s`
/// says that the shutter rolls: each point moves by the way that the camera went between the middle row and its own.
/// From the first row of a Kinect to the last a hand at 0.25 m/s goes 7 mm, as much as all other errors of a pose
/// together, and near points, mostly low in the picture, show it most. Points without depth are taken to be at
/// DepthOfOthers. The same frame where there is nothing to do.
FramePtr WithoutShutter(const FramePtr& frame, const std::optional<CameraRate>& rate);

}  // namespace yorb

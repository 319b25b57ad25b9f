// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "features/frame.h"
#include "tracking/motion_model.h"

namespace yorb {

/// How the camera moved from the middle row of a picture to the one at `y_px`, real pixels.
Rigid3 MotionToRow(const Rig& rig, const CameraRate& rate, double y_px);

/// The frame as a camera with all rows at once would have seen it when the middle row was read, where `rig.readout_s`
/// says that the shutter rolls: each point moves by the way that the camera went between the middle row and its own.
/// From the first row of a Kinect to the last a hand at 0.25 m/s goes 7 mm, as much as all other errors of a pose
/// together, and near points, mostly low in the picture, show it most. Points without depth are taken to be at the
/// median depth of the others. The same frame where there is nothing to do.
FramePtr WithoutShutter(const FramePtr& frame, const std::optional<CameraRate>& rate);

}  // namespace yorb

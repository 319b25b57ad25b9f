// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "features/frame.h"
#include "tracking/motion_model.h"

namespace yorb {

/// The frame as a camera with all rows at once would have seen it at the frame's time stamp, where `rig.readout_s` says
/// that the shutter rolls: each point goes back by the way that the camera moved between the stamp and the readout of
/// its row. A hand at 0.25 m/s is 7 mm further when the last row of a Kinect is read: as much as all other errors of a
/// pose together. Points without depth are taken to be at the median depth of the others. The same frame where there
/// is nothing to do.
FramePtr WithoutShutter(const FramePtr& frame, const std::optional<CameraRate>& rate);

}  // namespace yorb

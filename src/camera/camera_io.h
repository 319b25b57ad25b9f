// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "camera/rig.h"
#include "core/result.h"

namespace yorb {

/// Reads a camera file: ours, or an ORB-SLAM2/3 settings file (`%YAML:1.0` header, `Camera.*` and `Camera1.*` names,
/// doubled keys, CRLF). OpenCV, ROS camera_info, Kalibr and EuRoC calibrations are read, or refused with the reason.
/// Bad input names the file and the key.
Result<Rig> ReadCameraFile(const std::string& path);

/// Fits a rig to pictures of another size than its file states: scaled where the aspect is the same (the caller warns;
/// `*was_scaled` in the return says so), refused otherwise. A file that states no size takes the pictures'.
struct FittedRig {
  Rig rig;
  bool was_scaled = false;
};
Result<FittedRig> FitToPictures(const Rig& rig, int width, int height);

/// The YAML text of our own camera format.
std::string CameraFileText(const Rig& rig);

}  // namespace yorb

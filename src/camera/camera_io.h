// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "camera/rig.h"
#include "core/result.h"

namespace yorb {

// Our own camera format is flat YAML; fx, fy, cx and cy must be there, the rest may be left out:
//
//   type: pinhole                # the only one
//   name: tum_fr1                # for messages
//   width: 640                   # of the pictures that the numbers are for; left out: that of the pictures
//   height: 480
//   fps: 30                      # left out: as the time stamps say
//   fx: 517.306408               # pixels; pixel (0, 0) is the centre of the upper left one
//   fy: 516.469215
//   cx: 318.643040
//   cy: 255.313989
//   distortion: [k1, k2, p1, p2, k3, k4, k5, k6]   # 0, 4, 5 or 8 numbers in OpenCV's order
//   baseline_px: 40              # fx times the (virtual) baseline; or baseline_m in metres; left out: 0.08 m
//   close_factor: 40             # depth is trusted up to so many baselines
//   depth_factor: 5000           # units of a 16-bit depth picture in one metre
//   readout_s: 0.026             # a rolling shutter's time from the first row to the last; left out: 0, all at once
//
// Read as well: ORB-SLAM2 and ORB-SLAM3 settings (and OpenVSLAM's, which are near to them), ROS camera_info, OpenCV
// calibrations, Kalibr's camchain of one camera, EuRoC's sensor.yaml, VINS's pinhole cameras (camodocal), and the JSON
// of Open3D (intrinsic_matrix) and of librealsense (ppx, ppy, coeffs), whose depth_scale is a depth factor. ROS's
// region of interest is taken for the pictures' part of the whole picture. The calibration formats do not speak of
// depth: depth_factor, baseline_*, close_factor, readout_s and fps may be added to them as top-level keys of the names
// above; to ORB-SLAM's settings, too, but for fps. VINS's rolling_shutter and rolling_shutter_tr are readout_s.
//
// A file that states no depth factor gives a rig with depth_factor 0, "not known", and one without a rate fps 0. No
// default is taken for the depth factor, since a wrong one is a wrong scale: datasets refuses it when it meets a 16-bit
// depth picture, and takes the rate from the time stamps.

/// Reads a camera file of one of these dialects; one that cannot be read rightly is refused with the reason. Bad input
/// names the file and the key.
Result<Rig> ReadCameraFile(const std::string& path);

/// The same from text; `path` serves for messages only.
Result<Rig> ParseCameraFile(const std::string& text, const std::string& path);

/// Fits a rig to pictures of another size than its file states: scaled where the aspect is the same (the caller warns;
/// `was_scaled` says so), refused otherwise. A file that states no size takes the pictures'.
struct FittedRig {
  Rig rig;
  bool was_scaled = false;
};
Result<FittedRig> FitToPictures(const Rig& rig, int width, int height);

/// The YAML text of our own camera format.
std::string CameraFileText(const Rig& rig);

}  // namespace yorb

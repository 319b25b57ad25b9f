// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/trajectory.h"

#include "core/text.h"

namespace yorb {

std::string TumText(const Trajectory& trajectory) {
  constexpr int kDecimals = 9;
  std::string text;
  text.reserve(trajectory.size() * 120);
  for (const StampedPose& pose : trajectory) {
    const Eigen::Vector3d& t = pose.world_from_cam.translation;
    const Eigen::Quaterniond& q = pose.world_from_cam.rotation;
    text += ToString(pose.timestamp);
    for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()})
      text += ' ' + FormatFixed(value, kDecimals);
    text += '\n';
  }
  return text;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/shutter.h"

namespace yorb {

Rigid3 MotionToRow(const Rig& rig, const CameraRate& rate, double y_px) {
  return rate.After(rig.readout_s * (y_px / rig.camera.height - 0.5));
}

Eigen::Vector3d WhenMiddleRowWasRead(const Rig& rig, const CameraRate& rate, const Eigen::Vector2f& ideal_px,
                                     double y_px, double depth) {
  return MotionToRow(rig, rate, y_px).Inverse() * rig.camera.Unproject(ideal_px.x(), ideal_px.y(), depth);
}

float DepthOfOthers(const Frame& frame) {
  constexpr float kFarAway = 1e3f;
  const float median = frame.MedianDepth();
  return median > 0 ? median : kFarAway;
}

FramePtr WithoutShutter(const FramePtr& frame, const std::optional<CameraRate>& rate) {
  const Rig& rig = *frame->rig;
  if (rig.readout_s <= 0 || !rate || frame->size() == 0) return frame;
  const float unknown = DepthOfOthers(*frame);
  auto corrected = std::make_shared<Frame>(*frame);
  for (size_t i = 0; i < frame->size(); ++i) {
    const float depth = frame->HasDepth(i) ? frame->depth[i] : unknown;
    const Eigen::Vector3d x_in_cam =
        WhenMiddleRowWasRead(rig, *rate, frame->points_px[i], frame->keypoints[i].y, depth);
    if (!(x_in_cam.z() > 0)) continue;
    corrected->points_px[i] = rig.camera.Project(x_in_cam).cast<float>();
    if (!frame->HasDepth(i)) continue;
    corrected->depth[i] = static_cast<float>(x_in_cam.z());
    corrected->right_px[i] = corrected->points_px[i].x() - static_cast<float>(rig.VirtualBaselinePx() / x_in_cam.z());
  }
  corrected->grid = Grid(corrected->bounds, corrected->points_px);
  return corrected;
}

}  // namespace yorb

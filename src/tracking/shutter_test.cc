// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/shutter.h"

#include <gtest/gtest.h>

#include "map/synthetic_world.h"

namespace yorb {
namespace {

/// Turns a frame into what a rolling shutter makes of it: each point where it is when its row is read.
Frame Rolled(const Frame& frame, const CameraRate& rate, double readout_s) {
  Frame rolled = frame;
  Rig rig = *frame.rig;
  rig.readout_s = readout_s;
  rolled.rig = std::make_shared<const Rig>(rig);
  for (size_t i = 0; i < frame.size(); ++i) {
    Eigen::Vector3d x_in_cam = frame.PointInCam(i);
    double row = frame.points_px[i].y();
    for (int k = 0; k < 10; ++k) {  // the row at which it is read depends on where it is by then
      x_in_cam = rate.After(readout_s * (row / rig.camera.height - 0.5)) * frame.PointInCam(i);
      row = rig.camera.Project(x_in_cam).y();
    }
    rolled.points_px[i] = rig.camera.Project(x_in_cam).cast<float>();
    rolled.keypoints[i].x = rolled.points_px[i].x();
    rolled.keypoints[i].y = rolled.points_px[i].y();
    rolled.depth[i] = static_cast<float>(x_in_cam.z());
  }
  return rolled;
}

TEST(WithoutShutter, BringsEveryPointBackToTheStamp) {
  const SyntheticWorld world(1);
  const FramePtr truth = world.Look(Rigid3::Identity(), FrameId(0), Timestamp{0}).frame;
  const CameraRate rate{{0.3, -0.5, 0.2}, {0.4, 0.2, -0.3}};
  const auto rolled = std::make_shared<const Frame>(Rolled(*truth, rate, 0.03));
  const FramePtr corrected = WithoutShutter(rolled, rate);
  float worst_before = 0, worst = 0;
  for (size_t i = 0; i < truth->size(); ++i) {
    worst_before = std::max(worst_before, (rolled->points_px[i] - truth->points_px[i]).norm());
    worst = std::max(worst, (corrected->points_px[i] - truth->points_px[i]).norm());
    worst = std::max(worst, std::abs(corrected->right_px[i] - truth->right_px[i]));
  }
  EXPECT_GT(worst_before, 3);
  EXPECT_LT(worst, 0.01);
}

TEST(WithoutShutter, LeavesAGlobalShutterAndAnUnknownMotionAlone) {
  const SyntheticWorld world(1);
  const FramePtr frame = world.Look(Rigid3::Identity(), FrameId(0), Timestamp{0}).frame;
  const CameraRate rate{{0.3, -0.5, 0.2}, {0.4, 0.2, -0.3}};
  EXPECT_EQ(WithoutShutter(frame, rate), frame);
  const auto rolled = std::make_shared<const Frame>(Rolled(*frame, rate, 0.03));
  EXPECT_EQ(WithoutShutter(rolled, std::nullopt), rolled);
}

}  // namespace
}  // namespace yorb

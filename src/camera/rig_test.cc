// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/rig.h"

#include <gtest/gtest.h>

namespace yorb {
namespace {

Rig Freiburg1() {
  Rig rig;
  rig.camera.fx = 517.306408, rig.camera.fy = 516.469215, rig.camera.cx = 318.643040, rig.camera.cy = 255.313989;
  rig.camera.width = 640, rig.camera.height = 480;
  rig.camera.distortion = {0.262383, -0.953104, -0.005358, 0.002628, 1.163314, 0, 0, 0};
  return rig;
}

Pinhole Rational() {
  Pinhole camera = Freiburg1().camera;
  camera.distortion = {0.6, -2.8, 0.0006, -0.0003, 1.6, 0.48, -2.6, 1.5};  // of the kind that Azure Kinects report
  return camera;
}

TEST(Pinhole, ProjectUndoesUnproject) {
  const Pinhole camera = Freiburg1().camera;
  const Eigen::Vector3d x_in_cam = camera.Unproject(12.5, 471.25, 3.5);
  EXPECT_DOUBLE_EQ(x_in_cam.z(), 3.5);
  EXPECT_NEAR((camera.Project(x_in_cam) - Eigen::Vector2d(12.5, 471.25)).norm(), 0, 1e-10);
}

TEST(Pinhole, UndistortUndoesDistortAllOverThePicture) {
  for (const Pinhole& camera : {Freiburg1().camera, Rational()}) {
    std::vector<Eigen::Vector2d> ideal_px;
    std::vector<Eigen::Vector2f> distorted_px;
    for (int y = 20; y < 480; y += 40) {
      for (int x = 20; x < 640; x += 40) {
        ideal_px.emplace_back(x, y);
        distorted_px.push_back(camera.Distort(ideal_px.back()).cast<float>());
      }
    }
    const auto back_px = camera.Undistort(distorted_px);
    double furthest_px = 0, largest_move_px = 0;
    for (size_t i = 0; i < ideal_px.size(); ++i) {
      furthest_px = std::max(furthest_px, (back_px[i].cast<double>() - ideal_px[i]).norm());
      largest_move_px = std::max(largest_move_px, (distorted_px[i].cast<double>() - ideal_px[i]).norm());
    }
    EXPECT_LT(furthest_px, 0.02);
    EXPECT_GT(largest_move_px, 1.0) << "a lens that moves nothing tests nothing";
  }
}

TEST(Pinhole, EveryDistortionNumberIsUsed) {
  for (size_t i = 0; i < 8; ++i) {
    Pinhole camera = Freiburg1().camera;
    camera.distortion = {};
    EXPECT_FALSE(camera.HasDistortion());
    camera.distortion[i] = 0.05;
    EXPECT_TRUE(camera.HasDistortion());
    const Eigen::Vector2d corner_px(40, 30);
    const double moved_by_px = (camera.Distort(corner_px) - corner_px).norm();
    EXPECT_GT(moved_by_px, 0.1) << "number " << i;
    const auto back_px = camera.Undistort({camera.Distort(corner_px).cast<float>()});
    EXPECT_NEAR((back_px[0].cast<double>() - corner_px).norm(), 0, 0.02) << "number " << i;
  }
}

TEST(Rig, BoundsEncloseThePictureAndAreItselfWithoutDistortion) {
  Rig rig = Freiburg1();
  const PixelBounds distorted = rig.Bounds();
  rig.camera.distortion = {};
  const PixelBounds plain = rig.Bounds();
  EXPECT_EQ(plain.min_x, 0);
  EXPECT_EQ(plain.max_x, 640);
  EXPECT_EQ(plain.max_y, 480);
  EXPECT_NE(distorted.min_x, plain.min_x);
  EXPECT_TRUE(distorted.Contains(320, 240));
  EXPECT_FALSE(plain.Contains(640, 10));
}

TEST(Rig, CloseDepthIsSoManyBaselines) {
  const Rig rig = Freiburg1();
  EXPECT_NEAR(rig.CloseDepth(), 40 * 40 / 517.306408, 1e-12);
}

TEST(Rig, SaysWhatNoSensorHas) {
  EXPECT_EQ(Freiburg1().Oddity(), "");
  Rig rational = Freiburg1(), near = Freiburg1(), far = Freiburg1(), unlike = Freiburg1(), bent = Freiburg1(),
      wide = Freiburg1();
  rational.camera = Rational();
  EXPECT_EQ(rational.Oddity(), "");
  near.camera.fx = near.camera.fy = 5e-3;
  EXPECT_NE(near.Oddity(), "");
  far.camera.fx = far.camera.fy = 5e5;
  EXPECT_NE(far.Oddity(), "");
  unlike.camera.fy = 51.6;
  EXPECT_EQ(unlike.Oddity(), "fx and fy are very unlike");
  for (const double k1 : {50.0, -5.0, 1e300}) {
    bent.camera.distortion[0] = k1;
    EXPECT_NE(bent.Oddity().find("distortion"), std::string::npos) << k1;
  }
  wide.baseline_px = 1e6;
  EXPECT_NE(wide.Oddity().find("baseline"), std::string::npos);
}

}  // namespace
}  // namespace yorb

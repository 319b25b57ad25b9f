// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion/surfaces.h"

#include <gtest/gtest.h>

#include "motion/test_scene.h"

namespace yorb {
namespace {

// A corner of a room, as a camera sees it that looks into the corner: a wall ahead, one to the right, and the floor.
const std::vector<TestBox> kCorner = {
    {{-4, -3, 2}, {4, 2, 2.2}}, {{2, -3, -4}, {2.2, 2, 4}}, {{-4, 1.2, -4}, {4, 1.4, 4}}};
const std::vector<TestBox> kWall = {kCorner.front()};

class SurfacesTest : public ::testing::Test {
 protected:
  DepthGrid See(const Rigid3& cam_from_world, const std::vector<TestBox>& boxes) {
    return DepthGridMaker(rig_).Make(LookAtBoxes(rig_, cam_from_world, boxes, random_).depth);
  }

  void Remember(const std::vector<TestBox>& boxes, int64_t ms = 0, const Rigid3& place = Rigid3::Identity()) {
    surfaces_.Add(See(place, boxes), Timestamp{ms * 1'000'000}, {KeyframeId(0), place});
  }

  /// Where surfaces and three points in a corner of the picture, which cannot say it, put a camera.
  Rigid3 Align(const DepthGrid& grid, const Rigid3& truth, Rigid3 pose) {
    std::vector<PoseObservation> points;
    for (const Eigen::Vector3d& x_in_cam : {Eigen::Vector3d(-0.9, -0.9, 3), {-0.88, -0.9, 3}, {-0.9, -0.88, 3}}) {
      const Eigen::Vector2d px = rig_.camera.Project(x_in_cam);
      points.push_back({truth.Inverse() * x_in_cam, {.x_px = px.x(), .y_px = px.y()}});
    }
    for (int turn = 0; turn < 5; ++turn) {
      pose = OptimizePose(pose, points, Projection(rig_), surfaces_.Pair(grid, rig_, pose, map_)).cam_from_world;
    }
    return pose;
  }

  const Rig rig_ = DepthTestRig();
  const Map map_ = MapWithOneKeyframe();
  Random random_{1};
  Surfaces surfaces_;
  const Rigid3 into_corner_ = Rigid3::FromStep((Eigen::Matrix<double, 6, 1>() << 0.4, 0, 0, 0, 0, 0).finished()) *
                              Rigid3::FromStep((Eigen::Matrix<double, 6, 1>() << 0, -0.75, 0, 0, 0, 0).finished());
  const Rigid3 truth_ =  // a step further
      Rigid3::FromStep((Eigen::Matrix<double, 6, 1>() << 0.02, -0.05, 0.01, 0.06, -0.04, 0.05).finished());
};

TEST_F(SurfacesTest, ACornerSaysWhereTheCameraIs) {
  Remember(kCorner, 0, into_corner_);
  const Rigid3 truth = truth_ * into_corner_;
  const Rigid3 off = Align(See(truth, kCorner), truth, into_corner_) * truth.Inverse();
  EXPECT_LT(off.translation.norm(), 0.01);
  EXPECT_LT(off.RotationAngle(), 0.004);
}

TEST_F(SurfacesTest, AWallAloneSaysHowFarItIs) {
  Remember(kWall);
  const Rigid3 off = Align(See(truth_, kWall), truth_, Rigid3::Identity()) * truth_.Inverse();
  EXPECT_LT(std::abs((off.rotation * Eigen::Vector3d(0, 0, 3) + off.translation).z() - 3), 0.01);
}

TEST_F(SurfacesTest, PairsLieOnTheirPlanesUnderTheTruth) {
  Remember(kCorner, 0, into_corner_);
  const Rigid3 truth = truth_ * into_corner_;
  const auto pairs = surfaces_.Pair(See(truth, kCorner), rig_, truth, map_);
  ASSERT_GT(pairs.size(), 100u);
  double sum = 0;
  for (const PlaneObservation& pair : pairs) {
    EXPECT_NEAR(pair.normal_in_world.norm(), 1, 1e-9);
    const double distance = pair.normal_in_world.dot(truth.Inverse() * pair.x_in_cam) - pair.offset;
    EXPECT_LT(std::abs(distance), 4 * pair.sigma_m);
    sum += pair.weight;
  }
  EXPECT_LE(sum, Surfaces::kMostWeight + 1e-9);
}

TEST_F(SurfacesTest, WhatCameInFrontIsNoSurfaceOfBefore) {
  Remember(kWall);
  const std::vector<TestBox> with_person = {kWall.front(), {{-0.5, -1, 1.5}, {0.5, 1, 1.8}}};
  for (const PlaneObservation& pair :
       surfaces_.Pair(See(Rigid3::Identity(), with_person), rig_, Rigid3::Identity(), map_))
    EXPECT_GT(pair.x_in_cam.z(), 1.9);
}

TEST_F(SurfacesTest, KeepsTheNewestAndSomeBeforeIt) {
  Remember(kWall);
  const size_t one = surfaces_.Pair(See(Rigid3::Identity(), kWall), rig_, Rigid3::Identity(), map_).size();
  for (int ms = 33; ms < 2000; ms += 33) Remember(kWall, ms);
  const size_t several = surfaces_.Pair(See(Rigid3::Identity(), kWall), rig_, Rigid3::Identity(), map_).size();
  EXPECT_GT(several, 3 * one);
  EXPECT_LE(several, 5 * one);
  surfaces_.Forget();
  EXPECT_TRUE(surfaces_.Pair(See(Rigid3::Identity(), kWall), rig_, Rigid3::Identity(), map_).empty());
}

TEST_F(SurfacesTest, WithoutADepthPictureSaysNothing) {
  surfaces_.Add({}, Timestamp{0}, {KeyframeId(0), Rigid3::Identity()});
  EXPECT_TRUE(surfaces_.Pair(See(Rigid3::Identity(), kWall), rig_, Rigid3::Identity(), map_).empty());
  Remember(kWall);
  EXPECT_TRUE(surfaces_.Pair({}, rig_, Rigid3::Identity(), map_).empty());
}

TEST_F(SurfacesTest, WithoutPointsAWallSaysHowFarItIsAndTheRestIsAsExpected) {
  Remember(kWall);
  const DepthGrid grid = See(truth_, kWall);
  const ExpectedPose expected{Rigid3::Identity(), 1000 * Matrix6d::Identity()};
  Rigid3 pose;
  for (int turn = 0; turn < 5; ++turn) pose = AlignToPlanes(pose, surfaces_.Pair(grid, rig_, pose, map_), expected);
  const Eigen::Vector3d centre = pose.OriginInSource();
  EXPECT_LT(std::abs(centre.z() - truth_.OriginInSource().z()), 0.01) << "how far the wall is";
  EXPECT_LT(centre.head<2>().norm(), 0.03) << "where along the wall: about as expected";
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/camera_path.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace yorb {
namespace {

const Stage& SmallStage() {
  static const Stage kStage = [] {
    RoomOptions options;
    options.texture_size = 64;
    options.has_shadows = false;
    return MakeRoom(options).stage;
  }();
  return kStage;
}

class EveryPath : public testing::TestWithParam<std::string> {};

TEST_P(EveryPath, MovesAtAHandsSpeedWithoutJerks) {
  constexpr double kStep = 1 / 30.0;
  const CameraPath path(*ParsePathKind(GetParam()), SmallStage(), 20, 3);
  Rigid3 last = path.WorldFromCamera(0);
  Eigen::Vector3d last_velocity = (path.WorldFromCamera(kStep).translation - last.translation) / kStep;
  double way = 0, turned = 0;
  for (double t = kStep; t < 20; t += kStep) {
    const Rigid3 now = path.WorldFromCamera(t);
    const Eigen::Vector3d velocity = (now.translation - last.translation) / kStep;
    EXPECT_LT(velocity.norm(), 0.9) << t;
    EXPECT_LT((velocity - last_velocity).norm() / kStep, 3.5) << t;  // m/s^2
    EXPECT_LT((last.Inverse() * now).RotationAngle() / kStep, 1.5) << t;
    way += (now.translation - last.translation).norm();
    turned += (last.Inverse() * now).RotationAngle();
    last = now;
    last_velocity = velocity;
  }
  const bool is_static = GetParam() == "static", is_rpy = GetParam() == "rpy";
  EXPECT_EQ(way < 0.6, is_static || is_rpy) << way;
  EXPECT_EQ(turned < 0.7, is_static || GetParam() == "xyz") << turned;
  EXPECT_GT(way, 0.02);  // even a still hand trembles
}

TEST_P(EveryPath, HoldsTheCameraUprightInsideTheRoomAndClearOfPeople) {
  const CameraPath path(*ParsePathKind(GetParam()), SmallStage(), 20, 3);
  for (double t = 0; t < 20; t += 0.1) {
    const Rigid3 pose = path.WorldFromCamera(t);
    EXPECT_LT(std::abs(pose.translation.x()), 3.3);
    EXPECT_LT(std::abs(pose.translation.y()), 2.3);
    EXPECT_GT(pose.translation.z(), 0.7);
    EXPECT_LT((pose.rotation * Eigen::Vector3d::UnitY()).z(), -0.7) << "y is down";
    for (const Route& route : SmallStage().routes) {
      if (GetParam() != "loop" && &route != &SmallStage().routes.front()) continue;
      for (double at = 0; at < route.length(); at += 0.1) {
        EXPECT_GT((route.At(at).position - pose.translation.head<2>()).norm(), 0.5) << t;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, EveryPath, testing::ValuesIn(PathNames()), [](const auto& test) { return test.param; });

TEST(CameraPath, ALoopGoesRoundOnceAndComesBackToItsStart) {
  for (const double duration : {10.0, 40.0}) {
    const CameraPath path(PathKind::kLoop, SmallStage(), duration, 1);
    const Rigid3 back = path.WorldFromCamera(0).Inverse() * path.WorldFromCamera(duration);
    EXPECT_LT(back.translation.norm(), 0.03);
    EXPECT_LT(back.RotationAngle(), 0.03);
    const Rigid3 half = path.WorldFromCamera(0).Inverse() * path.WorldFromCamera(duration * 0.48);
    EXPECT_GT(half.RotationAngle(), 2.8);
    EXPECT_GT(half.translation.norm(), 2.0);
  }
}

TEST(CameraPath, AnotherSeedIsAnotherHand) {
  const CameraPath a(PathKind::kStatic, SmallStage(), 10, 1), b(PathKind::kStatic, SmallStage(), 10, 2);
  EXPECT_GT((a.WorldFromCamera(1).translation - b.WorldFromCamera(1).translation).norm(), 1e-4);
}

TEST(CameraPath, KnowsItsNames) {
  EXPECT_EQ(ParsePathKind("rpy"), PathKind::kRpy);
  EXPECT_EQ(ParsePathKind("loop"), PathKind::kLoop);
  EXPECT_FALSE(ParsePathKind("Loop"));
  EXPECT_FALSE(ParsePathKind(""));
}

TEST(Route, IsWalkedByLengthAndCloses) {
  const Route route({{0, 0}, {3, 0}, {3, 2}, {0, 2}});
  EXPECT_NEAR((route.At(0).position - route.At(route.length()).position).norm(), 0, 1e-9);
  EXPECT_NEAR((route.At(-1).position - route.At(route.length() - 1).position).norm(), 0, 1e-9);
  for (double at = 0; at < route.length(); at += 0.05) {
    const Eigen::Vector2d step = route.At(at + 0.01).position - route.At(at).position;
    EXPECT_NEAR(step.norm(), 0.01, 4e-4);
    EXPECT_GT(step.dot(Eigen::Vector2d(std::cos(route.At(at).heading), std::sin(route.At(at).heading))), 0.008);
  }
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/compass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "map/synthetic_world.h"
#include "optimize/test_lines.h"

namespace yorb {
namespace {

/// Keyframes that know no landmark, at these poses, each the parent of the next; they see a room's straight edges from
/// `seen_from`.
class CompassTest : public testing::Test {
 protected:
  KeyframeId Add(const Eigen::Quaterniond& said, const Eigen::Quaterniond& true_rotation, KeyframeId parent) {
    const auto number = map_.next_keyframe().value();
    const auto view = world_.Look(Rigid3::Identity(), FrameId(number), Timestamp{number});
    const KeyframeId id = map_.AddKeyframe(view.frame, {said, Eigen::Vector3d::Zero()}, parent);
    map_.SetLines(id, LinesOfARoom(true_rotation, 12, random_));
    return id;
  }

  static double OffDeg(const std::vector<Eigen::Vector3d>& directions, const Eigen::Vector3d& wanted) {
    double least = 90;
    for (const Eigen::Vector3d& d : directions) {
      least = std::min(least, std::atan2(d.cross(wanted).norm(), std::abs(d.dot(wanted))) * 180 / M_PI);
    }
    return least;
  }

  SyntheticWorld world_{1};
  Random random_{1};
  Map map_;
};

TEST_F(CompassTest, ARoomRunsInThreeDirections) {
  KeyframeId last;
  for (int k = 0; k < 10; ++k) {
    const Eigen::Quaterniond rotation = RotationFromVector({0.05 * k, 0.1 * k, -0.03 * k});
    last = Add(rotation, rotation, last);
  }
  const auto directions = DirectionsOf(map_, KeyframeId(0));
  ASSERT_EQ(directions.size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_LT(OffDeg(directions, Eigen::Vector3d::Unit(k)), 0.3);
}

TEST_F(CompassTest, TheFirstKeyframesCountMostAndManyAreNotTooMany) {
  KeyframeId last;
  for (int k = 0; k < 450; ++k) {
    const Eigen::Quaterniond rotation = RotationFromVector({0, 0.02 * k, 0});
    const double drift = k < 50 ? 0 : 0.02;  // of which half would be seen in all of them together
    last = Add(rotation * RotationFromVector({0, 0, drift}), rotation, last);
  }
  EXPECT_LT(OffDeg(DirectionsOf(map_, KeyframeId(0)), Eigen::Vector3d::UnitY()), 0.8);
}

TEST_F(CompassTest, EachSubMapHasDirectionsOfItsOwn) {
  const Eigen::Quaterniond other = RotationFromVector({0, 0.4, 0.2});
  KeyframeId a, b;
  for (int k = 0; k < 6; ++k) {
    const Eigen::Quaterniond rotation = RotationFromVector({0.1 * k, 0, 0.1 * k});
    a = Add(rotation, rotation, a);
    b = Add(rotation * other, rotation, b);
  }
  EXPECT_LT(OffDeg(DirectionsOf(map_, map_.Find(a)->root), Eigen::Vector3d::UnitY()), 0.3);
  EXPECT_LT(OffDeg(DirectionsOf(map_, map_.Find(b)->root), other.conjugate() * Eigen::Vector3d::UnitY()), 0.3);
  EXPECT_GT(OffDeg(DirectionsOf(map_, map_.Find(b)->root), Eigen::Vector3d::UnitY()), 5);
}

}  // namespace
}  // namespace yorb

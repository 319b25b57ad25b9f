// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/rigid3.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "geometry/test_poses.h"

namespace yorb {
namespace {

Rigid3 AnyPose(Random& random) { return RandomPose(random, 1.8, 5); }

void ExpectEqual(const Rigid3& a, const Rigid3& b) {
  EXPECT_LT((a.rotation.toRotationMatrix() - b.rotation.toRotationMatrix()).norm(), 1e-13);
  EXPECT_LT((a.translation - b.translation).norm(), 1e-12);
}

TEST(Rigid3, IsAGroupThatActsOnPoints) {
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const Rigid3 a = AnyPose(random), b = AnyPose(random), c = AnyPose(random);
    const Eigen::Vector3d x = InCube(random, 10);
    ExpectEqual(a * a.Inverse(), Rigid3::Identity());
    ExpectEqual(a.Inverse() * a, Rigid3::Identity());
    ExpectEqual((a * b) * c, a * (b * c));
    ExpectEqual(a * Rigid3::Identity(), a);
    ExpectEqual((a * b).Inverse(), b.Inverse() * a.Inverse());
    EXPECT_LT(((a * b) * x - a * (b * x)).norm(), 1e-12);
    EXPECT_LT((a * a.OriginInSource()).norm(), 1e-12);
  }
}

TEST(Rigid3, KeepsDistancesAndHandedness) {
  Random random(2);
  for (int k = 0; k < 200; ++k) {
    const Rigid3 a = AnyPose(random);
    const Eigen::Vector3d x = InCube(random, 10), y = InCube(random, 10);
    EXPECT_NEAR((a * x - a * y).norm(), (x - y).norm(), 1e-12);
    EXPECT_NEAR(a.rotation.toRotationMatrix().determinant(), 1, 1e-13);
  }
}

TEST(Rigid3, MatrixAndQuaternionMakeTheSame) {
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    const Rigid3 a = AnyPose(random);
    ExpectEqual(Rigid3(a.rotation.toRotationMatrix(), a.translation), a);
    const Eigen::Quaterniond longer(3.0 * a.rotation.coeffs());
    ExpectEqual(Rigid3(longer, a.translation), a);
  }
}

TEST(RotationFromVector, IsTheInverseOfVectorFromRotation) {
  Random random(4);
  for (double length : {0.0, 1e-12, 1e-8, 1e-6, 1e-3, 1.0, 3.0, M_PI - 1e-6}) {
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector3d v = length * InCube(random, 1).normalized();
      const Eigen::Quaterniond q = RotationFromVector(v);
      EXPECT_NEAR(q.norm(), 1, 1e-15);
      EXPECT_LT((VectorFromRotation(q) - v).norm(), 1e-9 * length + 1e-15);
      const Eigen::Quaterniond negative(-q.coeffs());  // the same rotation
      EXPECT_LT((VectorFromRotation(negative) - v).norm(), 1e-9 * length + 1e-15);
      EXPECT_NEAR(Rigid3(q, {0, 0, 0}).RotationAngle(), length, 1e-9 * length + 1e-15);
    }
  }
}

TEST(RotationFromVector, IsEigensAngleAxis) {
  Random random(5);
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector3d axis = InCube(random, 1).normalized();
    const double angle = random.Uniform(-6, 6);
    const Eigen::Matrix3d expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    EXPECT_LT((RotationFromVector(angle * axis).toRotationMatrix() - expected).norm(), 1e-14);
  }
}

TEST(Rigid3, StepMovesPointsAsItsJacobianSays) {
  Random random(6);
  const double h = 1e-6;
  for (int k = 0; k < 50; ++k) {
    const Rigid3 pose = AnyPose(random);
    const Eigen::Vector3d x = InCube(random, 5);
    Eigen::Matrix<double, 3, 6> analytic, numeric;
    analytic << -Skew(pose * x), Eigen::Matrix3d::Identity();
    for (int i = 0; i < 6; ++i) {
      const Eigen::Matrix<double, 6, 1> step = h * Eigen::Matrix<double, 6, 1>::Unit(i);
      numeric.col(i) = (Rigid3::FromStep(step) * pose * x - Rigid3::FromStep(-step) * pose * x) / (2 * h);
    }
    EXPECT_LT((analytic - numeric).norm(), 1e-7);
  }
}

TEST(Skew, IsTheCrossProduct) {
  const Eigen::Vector3d a(1, -2, 3), b(0.5, 4, -1);
  EXPECT_EQ((Skew(a) * b), a.cross(b));
  EXPECT_EQ(Skew(a), -Skew(a).transpose());
}

}  // namespace
}  // namespace yorb

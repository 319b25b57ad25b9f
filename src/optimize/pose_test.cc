// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/pose.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "optimize/residuals.h"

namespace yorb {
namespace {

Projection TestProjection() {
  Projection p;
  p.fx = 525, p.fy = 520, p.cx = 320, p.cy = 240, p.baseline_px = 40;
  return p;
}
TEST(OptimizePose, Smoke) {
  Random random(1);
  const Projection p = TestProjection();
  const Rigid3 truth(RotationFromVector({0.3, -0.2, 0.5}), {0.1, 0.2, -0.3});
  std::vector<PoseObservation> obs;
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector3d x(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(1, 5));
    PoseObservation o;
    o.x_in_world = truth.Inverse() * x;
    const Observation zero{0, 0, 0};
    const Eigen::Vector3d e = ErrorPx(x, zero, p);
    o.seen = {e.x(), e.y(), e.z(), 1};
    if (k % 3 == 0) o.seen.x_px += 50;
    obs.push_back(o);
  }
  const auto r = OptimizePose(
      Rigid3::FromStep((Eigen::Matrix<double, 6, 1>() << .05, -.05, .05, .1, .1, .1).finished()) * truth, obs, p);
  EXPECT_EQ(r.num_inliers, 200u);
  EXPECT_LT((r.cam_from_world * truth.Inverse()).translation.norm(), 1e-8);
}
}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/bundle_step.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "optimize/test_problems.h"

namespace yorb {
namespace {

/// The slow twin: all derivatives numeric, one dense matrix for poses and points together, no elimination.
struct DenseTwin {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
};

BundleValues Moved(const BundleProblem& problem, int parameter, double by) {
  BundleValues values{problem.poses, problem.points};
  const int num_pose_parameters = 6 * static_cast<int>(problem.poses.size());
  if (parameter < num_pose_parameters) {
    Rigid3& pose = values.poses[static_cast<size_t>(parameter / 6)];
    pose = Rigid3::FromStep(by * Vector6d::Unit(parameter % 6)) * pose;
  } else {
    const int k = parameter - num_pose_parameters;
    values.points[static_cast<size_t>(k / 3)][k % 3] += by;
  }
  return values;
}

/// All errors in standard deviations, weighted by Huber (lines: by Cauchy) at the problem's values.
Eigen::VectorXd Errors(const BundleProblem& problem, const BundleValues& values) {
  const auto num_seen = static_cast<Eigen::Index>(problem.seen.size());
  Eigen::VectorXd errors(3 * num_seen + static_cast<Eigen::Index>(problem.lines.size()));
  for (size_t k = 0; k < problem.seen.size(); ++k) {
    const auto& [pose, point, seen] = problem.seen[k];
    const double chi2 = Chi2(problem.poses[pose] * problem.points[point], seen, problem.projection);
    const double weight = RobustLoss(chi2, Chi2Bound(seen), true).weight * seen.inverse_variance;
    errors.segment<3>(3 * static_cast<Eigen::Index>(k)) =
        std::sqrt(weight) * ErrorPx(values.poses[pose] * values.points[point], seen, problem.projection);
  }
  for (size_t k = 0; k < problem.lines.size(); ++k) {
    const auto& [pose, normal, direction, sigma] = problem.lines[k];
    const auto error = [&, n = normal, d = direction, s = sigma](const Rigid3& p) { return n.dot(p.rotation * d) / s; };
    const double at_first = error(problem.poses[pose]);
    errors[3 * num_seen + static_cast<Eigen::Index>(k)] =
        error(values.poses[pose]) / std::sqrt(1 + at_first * at_first);
  }
  return errors;
}

DenseTwin MakeTwin(const BundleProblem& problem) {
  const auto size = static_cast<Eigen::Index>(6 * problem.poses.size() + 3 * problem.points.size());
  const double h = 1e-6;
  const Eigen::VectorXd errors = Errors(problem, {problem.poses, problem.points});
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(errors.size(), size);
  for (int k = 0; k < size; ++k) {
    if (k / 6 < static_cast<int>(problem.poses.size()) && problem.is_fixed[static_cast<size_t>(k / 6)]) continue;
    jacobian.col(k) = (Errors(problem, Moved(problem, k, h)) - Errors(problem, Moved(problem, k, -h))) / (2 * h);
  }
  return {jacobian.transpose() * jacobian, jacobian.transpose() * errors};
}

TEST(BundleStepper, StepsAsTheDenseNumericTwinDoes) {
  WorldOptions options;
  options.poses = 4, options.points = 30, options.fixed = 1;
  options.range = 0.5;
  options.noise = {1, 0.2, 0.2};
  BundleProblem problem = MakeWorld(options).problem;
  Random random(1);
  for (uint32_t pose = 0; pose < options.poses; ++pose) {
    for (int k = 0; k < 5; ++k) {
      const Eigen::Vector3d direction = InCube(random, 1).normalized();
      const Eigen::Vector3d normal = direction.cross(InCube(random, 1)).normalized();
      problem.lines.push_back({pose, problem.poses[pose].rotation * normal, direction + InCube(random, 0.03), 0.01});
    }
  }
  const DenseTwin twin = MakeTwin(problem);
  const BundleStructure structure = MakeBundleStructure(problem, std::vector<bool>(problem.seen.size(), true));
  BundleStepper stepper(problem.projection);
  stepper.Begin(structure, true);
  const BundleValues values{problem.poses, problem.points};
  const double cost = stepper.Linearize(values);
  EXPECT_NEAR(cost, stepper.Cost(values), 1e-9 * cost);
  stepper.Linearize(values);
  for (const double damping : {1e-4, 1e-2, 1.0, 100.0}) {
    Eigen::MatrixXd damped = twin.hessian;
    damped.diagonal() += damping * twin.hessian.diagonal();
    for (Eigen::Index k = 0; k < damped.rows(); ++k) damped(k, k) += damped(k, k) == 0 ? 1 : 0;  // fixed or unseen
    const Eigen::VectorXd step = damped.ldlt().solve(-twin.gradient);

    ASSERT_TRUE(stepper.Solve(damping));
    BundleValues moved = values;
    stepper.Apply(values, moved);
    Eigen::VectorXd found(step.size());
    for (size_t k = 0; k < problem.poses.size(); ++k) {
      const Rigid3 motion = moved.poses[k] * values.poses[k].Inverse();
      found.segment<3>(6 * static_cast<Eigen::Index>(k)) = VectorFromRotation(motion.rotation);
      found.segment<3>(6 * static_cast<Eigen::Index>(k) + 3) = motion.translation;
    }
    for (size_t k = 0; k < problem.points.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(6 * problem.poses.size() + 3 * k);
      found.segment<3>(row) = moved.points[k] - values.points[k];
    }
    EXPECT_LT((found - step).norm(), 1e-5 * step.norm()) << damping;
    const double predicted = -step.dot(twin.gradient + 0.5 * twin.hessian * step);
    EXPECT_NEAR(stepper.PredictedDecrease(), predicted, 1e-5 * predicted) << damping;
  }
}

TEST(BundleStructure, TiesTogetherOnlyPosesThatSeeAPointInCommon) {
  BundleProblem problem;
  problem.projection = KinectProjection();
  problem.poses.resize(4);
  problem.is_fixed = {true, false, false, false};
  problem.points.resize(3);
  for (const auto& [pose, point] : {std::pair<uint32_t, uint32_t>{3, 0}, {1, 0}, {2, 1}, {0, 1}, {0, 0}}) {
    problem.seen.push_back({pose, point, {}});
  }
  const BundleStructure s = MakeBundleStructure(problem, std::vector<bool>(5, true));
  EXPECT_EQ(s.free_poses, (std::vector<uint32_t>{1, 2, 3}));
  ASSERT_EQ(s.points.size(), 2u);
  EXPECT_EQ(s.links, (std::vector<uint32_t>{0, 2, 1}));
  const std::vector<std::pair<uint32_t, uint32_t>> blocks = {{0, 0}, {1, 1}, {2, 2}, {0, 2}};
  EXPECT_EQ(s.pattern.blocks, blocks);
  EXPECT_EQ(s.pair_slots, (std::vector<uint32_t>{0, 3, 2, 1}));
}

}  // namespace
}  // namespace yorb

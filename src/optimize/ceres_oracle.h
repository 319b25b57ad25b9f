// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <array>
#include <vector>

#include "optimize/bundle.h"
#include "optimize/pose.h"

// The same least squares in Ceres, with its own derivatives: the oracle of this room's tests and the other row of its
// benchmarks. Not part of the library.
namespace yorb {

/// A pose as Ceres moves it: rotation vector and translation.
using CeresPose = std::array<double, 6>;

inline CeresPose ToCeres(const Rigid3& pose) {
  const Eigen::Vector3d r = VectorFromRotation(pose.rotation), &t = pose.translation;
  return {r.x(), r.y(), r.z(), t.x(), t.y(), t.z()};
}

inline Rigid3 FromCeres(const CeresPose& p) { return {RotationFromVector({p[0], p[1], p[2]}), {p[3], p[4], p[5]}}; }

/// The errors of one observation, in standard deviations.
struct CeresError {
  Observation seen;
  Projection projection;
  double weight = 1;

  template <typename T>
  bool operator()(const T* pose, const T* point, T* error) const {
    T x[3];
    ceres::AngleAxisRotatePoint(pose, point, x);
    for (int k = 0; k < 3; ++k) x[k] += pose[3 + k];
    const double scale = std::sqrt(seen.inverse_variance * weight);
    const T x_px = projection.fx * x[0] / x[2] + projection.cx;
    error[0] = scale * (x_px - seen.x_px);
    error[1] = scale * (projection.fy * x[1] / x[2] + projection.cy - seen.y_px);
    if (seen.HasDepth()) error[2] = scale * (x_px - projection.baseline_px / x[2] - seen.right_px);
    return true;
  }

  static ceres::CostFunction* Make(const Observation& seen, const Projection& projection, double weight) {
    auto* error = new CeresError{seen, projection, weight};
    if (seen.HasDepth()) return new ceres::AutoDiffCostFunction<CeresError, 3, 6, 3>(error);
    return new ceres::AutoDiffCostFunction<CeresError, 2, 6, 3>(error);
  }
};

/// Huber's loss of an observation, or none.
inline ceres::LossFunction* CeresLoss(const Observation& seen, bool use_huber) {
  return use_huber ? new ceres::HuberLoss(std::sqrt(seen.HasDepth() ? kChi2Stereo : kChi2Mono)) : nullptr;
}

inline ceres::Solver::Options CeresOptions(double tolerance) {
  ceres::Solver::Options options;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 200;
  options.function_tolerance = tolerance;
  options.parameter_tolerance = options.gradient_tolerance = 1e-14;
  return options;
}

struct CeresPoseResult {
  Rigid3 cam_from_world;
  double cost = 0;
};

/// The pose of least cost for the observations that are chosen.
inline CeresPoseResult CeresOptimizePose(const Rigid3& guess, const std::vector<PoseObservation>& observations,
                                         const std::vector<bool>& is_chosen, const Projection& projection,
                                         double tolerance) {
  CeresPose pose = ToCeres(guess);
  std::vector<Eigen::Vector3d> points;
  points.reserve(observations.size());
  ceres::Problem problem;
  for (size_t k = 0; k < observations.size(); ++k) {
    if (!is_chosen[k]) continue;
    const PoseObservation& o = observations[k];
    points.push_back(o.x_in_world);
    problem.AddResidualBlock(CeresError::Make(o.seen, projection, o.weight), nullptr, pose.data(),
                             points.back().data());
    problem.SetParameterBlockConstant(points.back().data());
  }
  ceres::Solver::Options options = CeresOptions(tolerance);
  options.linear_solver_type = ceres::DENSE_QR;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return {FromCeres(pose), summary.final_cost};
}

struct CeresBundleResult {
  std::vector<Rigid3> poses;
  std::vector<Eigen::Vector3d> points;
  double cost = 0;
  int iterations = 0;
};

/// The poses and points of least cost for the observations that are chosen.
inline CeresBundleResult CeresAdjustBundle(const BundleProblem& problem, const std::vector<bool>& is_chosen,
                                           bool use_huber, double tolerance) {
  std::vector<CeresPose> poses;
  for (const Rigid3& pose : problem.poses) poses.push_back(ToCeres(pose));
  CeresBundleResult result;
  result.points = problem.points;
  ceres::Problem ceres_problem;
  ceres::Solver::Options options = CeresOptions(tolerance);
  options.linear_solver_type = problem.poses.size() > 100 ? ceres::SPARSE_SCHUR : ceres::DENSE_SCHUR;
  options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (size_t k = 0; k < problem.seen.size(); ++k) {
    if (!is_chosen[k]) continue;
    const BundleProblem::Seen& seen = problem.seen[k];
    double* pose = poses[seen.pose].data();
    double* point = result.points[seen.point].data();
    ceres_problem.AddResidualBlock(CeresError::Make(seen.observation, problem.projection, 1),
                                   CeresLoss(seen.observation, use_huber), pose, point);
    if (problem.is_fixed[seen.pose]) ceres_problem.SetParameterBlockConstant(pose);
    options.linear_solver_ordering->AddElementToGroup(point, 0);
    options.linear_solver_ordering->AddElementToGroup(pose, 1);
  }
  ceres::Solver::Summary summary;
  ceres::Solve(options, &ceres_problem, &summary);
  for (const CeresPose& pose : poses) result.poses.push_back(FromCeres(pose));
  result.cost = summary.final_cost;
  result.iterations = static_cast<int>(summary.iterations.size());
  return result;
}

}  // namespace yorb

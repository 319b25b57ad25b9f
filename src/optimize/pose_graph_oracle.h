// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <vector>

#include "optimize/ceres_oracle.h"
#include "optimize/pose_graph.h"

// The pose graph in Ceres, with its own derivatives: for tests and benchmarks. Not part of the library.
namespace yorb {

/// The error of one edge, in standard deviations.
struct CeresEdgeError {
  Rigid3 from_from_to;  ///< measured
  double rotation_scale = 1, translation_scale = 1;

  template <typename T>
  bool operator()(const T* from, const T* to, T* error) const {
    T q_to[4], q_from[4], moved[4], difference[4];
    ceres::AngleAxisToQuaternion(from, q_from);
    ceres::AngleAxisToQuaternion(to, q_to);
    const T conjugate[4] = {q_from[0], -q_from[1], -q_from[2], -q_from[3]};
    ceres::QuaternionProduct(q_to, conjugate, moved);
    const Eigen::Quaterniond& r = from_from_to.rotation;
    const T measured[4] = {T(r.w()), T(r.x()), T(r.y()), T(r.z())};
    ceres::QuaternionProduct(measured, moved, difference);
    ceres::QuaternionToAngleAxis(difference, error);
    T x[3], y[3];
    ceres::QuaternionRotatePoint(moved, from + 3, x);
    for (int k = 0; k < 3; ++k) x[k] = to[3 + k] - x[k];
    ceres::QuaternionRotatePoint(measured, x, y);
    for (int k = 0; k < 3; ++k) {
      error[k] *= rotation_scale;
      error[3 + k] = translation_scale * (y[k] + from_from_to.translation[k]);
    }
    return true;
  }
};

struct CeresPoseGraphResult {
  std::vector<Rigid3> poses;
  double cost = 0;
  int iterations = 0;
};

/// The poses of least cost.
inline CeresPoseGraphResult CeresAdjustPoseGraph(const PoseGraph& graph, const PoseGraphOptions& options,
                                                 double tolerance) {
  std::vector<CeresPose> poses;
  for (const Rigid3& pose : graph.poses) poses.push_back(ToCeres(pose));
  ceres::Problem problem;
  for (const PoseGraph::Edge& edge : graph.edges) {
    const double scale = std::sqrt(edge.weight);
    // Huber's loss of the weighted error, with the weight taken out of its bound.
    ceres::LossFunction* loss = edge.is_robust ? new ceres::HuberLoss(options.huber_sigmas * scale) : nullptr;
    auto* error = new CeresEdgeError{edge.to_from_from.Inverse(), scale / options.rotation_sigma_rad,
                                     scale / options.translation_sigma};
    double* from = poses[edge.from].data();
    double* to = poses[edge.to].data();
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<CeresEdgeError, 6, 6, 6>(error), loss, from, to);
    if (graph.is_fixed[edge.from]) problem.SetParameterBlockConstant(from);
    if (graph.is_fixed[edge.to]) problem.SetParameterBlockConstant(to);
  }
  ceres::Solver::Options solver = CeresOptions(tolerance);
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  CeresPoseGraphResult result;
  for (const CeresPose& pose : poses) result.poses.push_back(FromCeres(pose));
  result.cost = summary.final_cost;
  result.iterations = static_cast<int>(summary.iterations.size());
  return result;
}

}  // namespace yorb

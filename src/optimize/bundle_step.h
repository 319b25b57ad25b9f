// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimize/bundle_structure.h"
#include "optimize/residuals.h"

namespace yorb {

/// Poses and points on their way to the optimum; rows as in the problem.
struct BundleValues {
  std::vector<Rigid3> poses;
  std::vector<Eigen::Vector3d> points;
};

/// The steps of Levenberg-Marquardt: `Begin`, then again and again `Linearize`, `Solve` (with more damping where the
/// step fails) and `Apply`. Memory is taken in `Begin` only.
class BundleStepper {
 public:
  explicit BundleStepper(const Projection& projection) : projection_(projection) {}

  /// Takes up a structure, which must outlive the steps.
  void Begin(const BundleStructure& structure, bool use_huber);

  /// The cost of the values: half the (robust) chi-square.
  double Cost(const BundleValues& values);

  /// Fills the normal equations at the values; gives the cost.
  double Linearize(const BundleValues& values);

  /// Finds the step at which the damped quadratic is least. False where there is none.
  bool Solve(double damping);

  /// By how much the quadratic says that the step lowers the cost.
  double PredictedDecrease() const { return predicted_decrease_; }

  /// Writes `from` moved by the step into `to`, which is a copy of `from` but for what the step moves.
  void Apply(const BundleValues& from, BundleValues& to) const;

 private:
  using Matrix63d = Eigen::Matrix<double, 6, 3>;
  struct PointBlock {
    Eigen::Matrix3d hessian;
    Eigen::Vector3d gradient;
    Eigen::Matrix3d lower_inverse;  ///< L^-1 of the damped hessian L L^T
    Eigen::Vector3d reduced;        ///< L^-1 * gradient
    Eigen::Vector3d step;
  };

  void SetRotations(const BundleValues& values);
  void LinearizeTies(const BundleValues& values);
  void LinearizeLines();
  void LinearizePoint(const BundleStructure::Point& point, const Eigen::Vector3d& x_in_world, PointBlock& block);
  bool Eliminate(const BundleStructure::Point& point, double damping, PointBlock& block);
  void BackSubstitute(const BundleStructure::Point& point, PointBlock& block) const;

  const Projection projection_;
  const BundleStructure* structure_ = nullptr;
  bool use_huber_ = false;
  std::vector<Eigen::Matrix3d> rotations_;  // a row a pose of the problem
  std::vector<Eigen::Vector3d> translations_;
  std::vector<Matrix6d> pose_hessians_;  // a row a free pose; the upper half
  std::vector<Vector6d> pose_gradients_;
  std::vector<Matrix6d> tie_blocks_;      // a row a tie: the block of (earlier, later) free pose
  std::vector<PointBlock> point_blocks_;  // a row a point of the structure
  std::vector<Matrix63d> link_blocks_;    // J_pose^T W J_point
  std::vector<Matrix63d> eliminated_;     // link_blocks_ * L^-T
  ReducedSystem system_;
  ReducedSolver solver_;
  double cost_ = 0, predicted_decrease_ = 0;
};

}  // namespace yorb

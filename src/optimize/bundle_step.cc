// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/bundle_step.h"

#include <algorithm>
#include <cmath>

#include "optimize/levenberg_marquardt.h"
#include "optimize/relative_pose.h"

namespace yorb {
namespace {

/// L^-1 of the Cholesky factor of a 3x3 matrix; false where it is not positive definite.
bool InverseCholesky(const Eigen::Matrix3d& m, Eigen::Matrix3d& inverse) {
  const double d0 = m(0, 0);
  if (!(d0 > 0)) return false;
  const double i00 = 1.0 / std::sqrt(d0);
  const double l10 = m(1, 0) * i00, l20 = m(2, 0) * i00;
  const double d1 = m(1, 1) - l10 * l10;
  if (!(d1 > 0)) return false;
  const double i11 = 1.0 / std::sqrt(d1);
  const double l21 = (m(2, 1) - l20 * l10) * i11;
  const double d2 = m(2, 2) - l20 * l20 - l21 * l21;
  if (!(d2 > 0)) return false;
  const double i22 = 1.0 / std::sqrt(d2);
  const double i10 = -l10 * i00 * i11;
  const double i21 = -l21 * i11 * i22;
  const double i20 = -(l20 * i00 + l21 * i10) * i22;
  inverse << i00, 0, 0, i10, i11, 0, i20, i21, i22;
  return std::isfinite(i00 + i11 + i22 + i10 + i20 + i21);
}

/// `block -= a * b^T`, the innermost work of all, by columns: `a` stays in registers.
void SubtractOuter(const Eigen::Matrix<double, 6, 3>& a, const Eigen::Matrix<double, 6, 3>& b, Matrix6d& block) {
  const Vector6d a0 = a.col(0), a1 = a.col(1), a2 = a.col(2);
  for (int j = 0; j < 6; ++j) block.col(j) -= a0 * b(j, 0) + a1 * b(j, 1) + a2 * b(j, 2);
}

double CostOf(const BundleProblem::Tie& tie, const BundleValues& values) {
  const Vector6d error = RelativePoseError(values.poses[tie.to], values.poses[tie.from], tie.to_from_from.Inverse());
  return 0.5 * error.dot(tie.information * error);
}

/// How far a line is from running in its direction, in standard deviations.
double ErrorOf(const BundleProblem::Line& line, const Eigen::Matrix3d& rotation) {
  return line.normal_in_cam.dot(rotation * line.direction_in_world) / line.sigma;
}

/// Cauchy's loss and its derivative by the chi-square.
Loss CauchyLoss(double chi2) { return {0.5 * std::log1p(chi2), 1 / (1 + chi2)}; }

}  // namespace

void BundleStepper::Begin(const BundleStructure& structure, bool use_huber) {
  structure_ = &structure;
  use_huber_ = use_huber;
  pose_hessians_.resize(structure.free_poses.size());
  pose_gradients_.resize(structure.free_poses.size());
  tie_blocks_.resize(structure.ties.size());
  point_blocks_.resize(structure.points.size());
  link_blocks_.resize(structure.links.size());
  eliminated_.resize(structure.links.size());
  system_.pattern = structure.pattern;
  system_.blocks.resize(structure.pattern.blocks.size());
  system_.right.resize(structure.pattern.size);
  solver_ = ReducedSolver(structure.pattern);
}

void BundleStepper::SetRotations(const BundleValues& values) {
  rotations_.resize(values.poses.size());
  translations_.resize(values.poses.size());
  for (size_t k = 0; k < values.poses.size(); ++k) {
    rotations_[k] = values.poses[k].rotation.toRotationMatrix();
    translations_[k] = values.poses[k].translation;
  }
}

double BundleStepper::Cost(const BundleValues& values) {
  SetRotations(values);
  double cost = 0;
  for (const BundleStructure::Point& point : structure_->points) {
    const Eigen::Vector3d& x_in_world = values.points[point.row];
    for (uint32_t k = point.entries_begin; k < point.entries_end; ++k) {
      const BundleStructure::Entry& entry = structure_->entries[k];
      const Eigen::Vector3d x = rotations_[entry.pose] * x_in_world + translations_[entry.pose];
      const double chi2 = Chi2(x, entry.observation, projection_);
      cost += RobustLoss(chi2, Chi2Bound(entry.observation), use_huber_).cost;
    }
  }
  for (const BundleStructure::Tie& tie : structure_->ties) cost += CostOf(tie.tie, values);
  for (const BundleStructure::Line& line : structure_->lines) {
    const double error = ErrorOf(line.line, rotations_[line.line.pose]);
    cost += CauchyLoss(error * error).cost;
  }
  return cost;
}

double BundleStepper::Linearize(const BundleValues& values) {
  SetRotations(values);
  cost_ = 0;
  std::fill(pose_hessians_.begin(), pose_hessians_.end(), Matrix6d::Zero());
  std::fill(pose_gradients_.begin(), pose_gradients_.end(), Vector6d::Zero());
  std::fill(link_blocks_.begin(), link_blocks_.end(), Matrix63d::Zero());
  for (size_t k = 0; k < structure_->points.size(); ++k) {
    const BundleStructure::Point& point = structure_->points[k];
    LinearizePoint(point, values.points[point.row], point_blocks_[k]);
  }
  LinearizeTies(values);
  LinearizeLines();
  return cost_;
}

void BundleStepper::LinearizeTies(const BundleValues& values) {
  constexpr uint32_t kNone = BundleStructure::kNone;
  for (size_t k = 0; k < structure_->ties.size(); ++k) {
    const BundleStructure::Tie& tie = structure_->ties[k];
    // The error seen from `to`, where the information is; its sign does not matter.
    const RelativePoseJacobians j =
        LinearizeRelativePose(values.poses[tie.tie.to], values.poses[tie.tie.from], tie.tie.to_from_from.Inverse());
    const Matrix6d &by_to = j.by_from, &by_from = j.by_to;
    const Vector6d pull = tie.tie.information * j.error;
    cost_ += 0.5 * j.error.dot(pull);
    if (tie.free_to != kNone) {
      pose_hessians_[tie.free_to] += by_to.transpose() * tie.tie.information * by_to;
      pose_gradients_[tie.free_to] += by_to.transpose() * pull;
    }
    if (tie.free_from != kNone) {
      pose_hessians_[tie.free_from] += by_from.transpose() * tie.tie.information * by_from;
      pose_gradients_[tie.free_from] += by_from.transpose() * pull;
    }
    if (tie.slot == kNone) continue;
    const bool is_from_first = tie.free_from < tie.free_to;
    const Matrix6d &first = is_from_first ? by_from : by_to, &second = is_from_first ? by_to : by_from;
    tie_blocks_[k] = first.transpose() * tie.tie.information * second;
  }
}

void BundleStepper::LinearizeLines() {
  for (const auto& [line, free] : structure_->lines) {
    const Eigen::Vector3d direction_in_cam = rotations_[line.pose] * line.direction_in_world;
    const Eigen::Vector3d jacobian = direction_in_cam.cross(line.normal_in_cam) / line.sigma;
    const double error = line.normal_in_cam.dot(direction_in_cam) / line.sigma;
    const Loss loss = CauchyLoss(error * error);
    cost_ += loss.cost;
    pose_hessians_[free].topLeftCorner<3, 3>().noalias() += loss.weight * jacobian * jacobian.transpose();
    pose_gradients_[free].head<3>() += loss.weight * error * jacobian;
  }
}

void BundleStepper::LinearizePoint(const BundleStructure::Point& point, const Eigen::Vector3d& x_in_world,
                                   PointBlock& block) {
  block.hessian.setZero();
  block.gradient.setZero();
  for (uint32_t k = point.entries_begin; k < point.entries_end; ++k) {
    const BundleStructure::Entry& entry = structure_->entries[k];
    const Eigen::Matrix3d& rotation = rotations_[entry.pose];
    const Eigen::Vector3d x = rotation * x_in_world + translations_[entry.pose];
    const Quadratic q = yorb::Linearize(x, entry.observation, 1.0, use_huber_, projection_);
    cost_ += q.cost;
    if (!q.has_pull) continue;
    const Eigen::Matrix3d by_point = q.hessian * rotation;
    block.hessian.noalias() += rotation.transpose() * by_point;
    block.gradient.noalias() += rotation.transpose() * q.gradient;
    if (entry.link == BundleStructure::kNone) continue;
    Matrix63d& link = link_blocks_[entry.link];
    link.topRows<3>() += CrossColumns(x, by_point);
    link.bottomRows<3>() += by_point;
    const Eigen::Matrix3d cross = CrossColumns(x, q.hessian).transpose();
    Matrix6d& pose = pose_hessians_[entry.free];
    pose.topLeftCorner<3, 3>() += CrossColumns(x, cross);
    pose.topRightCorner<3, 3>() += cross.transpose();
    pose.bottomRightCorner<3, 3>() += q.hessian;
    pose_gradients_[entry.free].head<3>() += x.cross(q.gradient);
    pose_gradients_[entry.free].tail<3>() += q.gradient;
  }
}

bool BundleStepper::Solve(double damping) {
  std::fill(system_.blocks.begin(), system_.blocks.end(), Matrix6d::Zero());
  for (size_t k = 0; k < pose_hessians_.size(); ++k) {
    system_.blocks[k] = pose_hessians_[k];  // the diagonal comes first in the pattern
    system_.blocks[k].diagonal() += damping * DampingScale(pose_hessians_[k]);
    system_.right[k] = -pose_gradients_[k];
  }
  for (size_t k = 0; k < tie_blocks_.size(); ++k) {
    const uint32_t slot = structure_->ties[k].slot;
    if (slot != BundleStructure::kNone) system_.blocks[slot] += tie_blocks_[k];
  }
  for (size_t k = 0; k < point_blocks_.size(); ++k) {
    if (!Eliminate(structure_->points[k], damping, point_blocks_[k])) return false;
  }
  if (!solver_.Solve(system_)) return false;

  // The step solves (H + damping * D) * step = -gradient, so the quadratic falls by the following.
  double decrease = 0;
  for (uint32_t k = 0; k < pose_hessians_.size(); ++k) {
    const Vector6d step = solver_.Solution(k);
    const Vector6d scaled = DampingScale(pose_hessians_[k]).cwiseProduct(step);
    decrease += 0.5 * step.dot(damping * scaled - pose_gradients_[k]);
  }
  for (size_t k = 0; k < point_blocks_.size(); ++k) {
    PointBlock& block = point_blocks_[k];
    BackSubstitute(structure_->points[k], block);
    const Eigen::Vector3d scaled = DampingScale(block.hessian).cwiseProduct(block.step);
    decrease += 0.5 * block.step.dot(damping * scaled - block.gradient);
  }
  predicted_decrease_ = decrease;
  return std::isfinite(decrease);
}

bool BundleStepper::Eliminate(const BundleStructure::Point& point, double damping, PointBlock& block) {
  Eigen::Matrix3d damped = block.hessian;
  damped.diagonal() += damping * DampingScale(block.hessian);
  if (!InverseCholesky(damped, block.lower_inverse)) return false;
  block.reduced.noalias() = block.lower_inverse * block.gradient;
  for (uint32_t a = point.links_begin; a < point.links_end; ++a) {
    eliminated_[a].noalias() = link_blocks_[a] * block.lower_inverse.transpose();
    system_.right[structure_->links[a]].noalias() += eliminated_[a] * block.reduced;
  }
  const uint32_t* slot = structure_->pair_slots.data() + point.pairs_begin;
  for (uint32_t a = point.links_begin; a < point.links_end; ++a) {
    for (uint32_t b = a; b < point.links_end; ++b) {
      SubtractOuter(eliminated_[a], eliminated_[b], system_.blocks[*slot++]);
    }
  }
  return true;
}

void BundleStepper::BackSubstitute(const BundleStructure::Point& point, PointBlock& block) const {
  Eigen::Vector3d pull = block.reduced;
  for (uint32_t a = point.links_begin; a < point.links_end; ++a) {
    pull.noalias() += eliminated_[a].transpose() * solver_.Solution(structure_->links[a]);
  }
  block.step.noalias() = -(block.lower_inverse.transpose() * pull);
}

void BundleStepper::Apply(const BundleValues& from, BundleValues& to) const {
  for (uint32_t k = 0; k < structure_->free_poses.size(); ++k) {
    const uint32_t pose = structure_->free_poses[k];
    to.poses[pose] = Rigid3::FromStep(solver_.Solution(k)) * from.poses[pose];
  }
  for (size_t k = 0; k < structure_->points.size(); ++k) {
    const uint32_t row = structure_->points[k].row;
    to.points[row] = from.points[row] + point_blocks_[k].step;
  }
}

}  // namespace yorb

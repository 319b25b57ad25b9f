// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/smooth_trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/usual_motion.h"
#include "optimize/block_cholesky.h"
#include "optimize/relative_pose.h"

namespace yorb {
namespace {

using Matrix3d = Eigen::Matrix3d;

constexpr double kUnderstated = 4;          // a pose errs by so many times what its points say: they lie in one map
constexpr double kLeastInformation = 1e-2;  // where no point holds a pose: 10 rad and 10 m
constexpr double kShortestStepS = 1e-3;     // what is shorter costs digits

/// Of the step by which the true pose is off.
Matrix6d Precision(const Matrix6d& information) {
  return (information + kLeastInformation * Matrix6d::Identity()) / (kUnderstated * kUnderstated);
}

/// The step that leads from what was measured to a pose.
Vector6d StepFromMeasured(const MeasuredPose& measured, const Rigid3& cam_from_world) {
  return StepFrom(cam_from_world * measured.cam_from_world.Inverse());
}

/// How the speed changes at the middle one of three poses: in the camera's axes for the turn, in the world's for the
/// place; and the derivatives by a step of each pose.
struct Acceleration {
  Vector6d value;
  std::array<Matrix6d, 3> by;
};

Acceleration AccelerationAt(const Rigid3* poses, double before_s, double after_s) {
  const double between_s = 0.5 * (before_s + after_s);
  const std::array<double, 3> share = {1 / (before_s * between_s), -(1 / before_s + 1 / after_s) / between_s,
                                       1 / (after_s * between_s)};
  const Eigen::Quaterniond first = poses[1].rotation * poses[0].rotation.conjugate();
  const Eigen::Quaterniond second = poses[2].rotation * poses[1].rotation.conjugate();
  Acceleration a;
  a.value.setZero();
  a.value.head<3>() = (VectorFromRotation(second) / after_s - VectorFromRotation(first) / before_s) / between_s;
  for (size_t k = 0; k < 3; ++k) {
    a.value.tail<3>() += share[k] * poses[k].OriginInSource();
    a.by[k].setZero();
    a.by[k].bottomRightCorner<3, 3>() = -share[k] * poses[k].rotation.conjugate().toRotationMatrix();
  }
  const Matrix3d over_first = Matrix3d::Identity() / (before_s * between_s);
  const Matrix3d over_second = Matrix3d::Identity() / (after_s * between_s);
  a.by[0].topLeftCorner<3, 3>() = over_first * first.toRotationMatrix();
  a.by[1].topLeftCorner<3, 3>() = -over_second * second.toRotationMatrix() - over_first;
  a.by[2].topLeftCorner<3, 3>() = over_second;
  return a;
}

/// A path without a pause.
class Piece {
 public:
  /// `seconds`: from each pose to the next.
  Piece(const MeasuredPose* measured, std::vector<double> seconds);

  std::vector<Rigid3> Smooth();

 private:
  static BlockPattern PatternOf(uint32_t size);
  size_t BlockOf(size_t row, size_t column) const { return column == row ? row : size_ + row + column - 1; }

  void Minimize(double ease);
  void Linearize(double ease);
  double MedianChi2() const;

  const MeasuredPose* measured_;
  std::vector<double> seconds_;
  size_t size_;
  std::vector<Matrix6d> precision_;
  std::vector<Rigid3> poses_;
  BlockCholesky cholesky_;
  std::vector<Matrix6d> blocks_;
  Eigen::VectorXd right_;
};

Piece::Piece(const MeasuredPose* measured, std::vector<double> seconds)
    : measured_(measured),
      seconds_(std::move(seconds)),
      size_(seconds_.size() + 1),
      poses_(size_),
      cholesky_(PatternOf(static_cast<uint32_t>(size_))) {
  precision_.reserve(size_);
  for (size_t i = 0; i < size_; ++i) precision_.push_back(Precision(measured[i].information));
}

/// Each pose is tied to the next two.
BlockPattern Piece::PatternOf(uint32_t size) {
  BlockPattern pattern;
  pattern.size = size;
  for (uint32_t i = 0; i < size; ++i) pattern.blocks.emplace_back(i, i);
  for (uint32_t i = 0; i + 1 < size; ++i) {
    pattern.blocks.emplace_back(i, i + 1);
    if (i + 2 < size) pattern.blocks.emplace_back(i, i + 2);
  }
  return pattern;
}

/// More acceleration is allowed until the path keeps to what was measured.
std::vector<Rigid3> Piece::Smooth() {
  constexpr double kMostChi2 = 3, kMostEase = 1e9;  // of six degrees of freedom; hand-held it is 0.1 to 0.9
  for (double ease = 1;; ease *= 2) {
    Minimize(ease);
    if (MedianChi2() <= kMostChi2 || ease >= kMostEase) return poses_;
  }
}

void Piece::Minimize(double ease) {
  constexpr int kMostRounds = 8;
  constexpr double kSmallStep = 1e-6;
  for (size_t i = 0; i < size_; ++i) poses_[i] = measured_[i].cam_from_world;
  for (int round = 0; round < kMostRounds; ++round) {
    Linearize(ease);
    if (!cholesky_.Factorize(blocks_)) return;
    cholesky_.Solve(right_);
    for (size_t i = 0; i < size_; ++i) {
      poses_[i] = Rigid3::FromStep(right_.segment<6>(static_cast<Eigen::Index>(6 * i))) * poses_[i];
    }
    if (right_.lpNorm<Eigen::Infinity>() < kSmallStep) return;
  }
}

void Piece::Linearize(double ease) {
  constexpr double kLeap = 5;  // standard deviations; beyond, Huber's loss: what leaps is the map and not the camera
  Vector6d usual;
  usual << Eigen::Vector3d::Constant(kUsualTurnAcceleration), Eigen::Vector3d::Constant(kUsualAcceleration);
  const Vector6d weights = (ease * usual).cwiseAbs2().cwiseInverse();
  blocks_.assign(3 * size_ - 3, Matrix6d::Zero());
  right_.setZero(static_cast<Eigen::Index>(6 * size_));
  const auto right = [&](size_t i) { return right_.segment<6>(static_cast<Eigen::Index>(6 * i)); };
  for (size_t i = 0; i < size_; ++i) {
    blocks_[i] = precision_[i];
    right(i) = -precision_[i] * StepFromMeasured(measured_[i], poses_[i]);
  }
  for (size_t i = 0; i + 2 < size_; ++i) {
    const Acceleration a = AccelerationAt(&poses_[i], seconds_[i], seconds_[i + 1]);
    const double sigmas = std::sqrt(a.value.cwiseAbs2().dot(weights));
    const Vector6d pull = std::min(1.0, kLeap / std::max(sigmas, kLeap)) * weights;
    for (size_t m = 0; m < 3; ++m) {
      const Matrix6d weighted = a.by[m].transpose() * pull.asDiagonal();
      right(i + m) -= weighted * a.value;
      for (size_t n = m; n < 3; ++n) blocks_[BlockOf(i + m, i + n)] += weighted * a.by[n];
    }
  }
}

/// Of the path by what was measured.
double Piece::MedianChi2() const {
  std::vector<double> chi2(size_);
  for (size_t i = 0; i < size_; ++i) {
    const Vector6d step = StepFromMeasured(measured_[i], poses_[i]);
    chi2[i] = step.dot(precision_[i] * step);
  }
  const auto middle = chi2.begin() + static_cast<std::ptrdiff_t>(size_ / 2);
  std::nth_element(chi2.begin(), middle, chi2.end());
  return *middle;
}

}  // namespace

std::vector<Rigid3> SmoothTrajectory(const std::vector<MeasuredPose>& measured) {
  std::vector<Rigid3> result;
  result.reserve(measured.size());
  while (result.size() < measured.size()) {
    const size_t begin = result.size();
    std::vector<double> seconds;
    for (size_t i = begin; i + 1 < measured.size(); ++i) {
      const double step_s = SecondsBetween(measured[i].timestamp, measured[i + 1].timestamp);
      if (step_s < 0 || step_s > kLongestPause) break;
      seconds.push_back(std::max(step_s, kShortestStepS));
    }
    if (seconds.size() < 2) {
      for (size_t i = 0; i <= seconds.size(); ++i) result.push_back(measured[begin + i].cam_from_world);
      continue;
    }
    const std::vector<Rigid3> smooth = Piece(&measured[begin], std::move(seconds)).Smooth();
    result.insert(result.end(), smooth.begin(), smooth.end());
  }
  return result;
}

}  // namespace yorb

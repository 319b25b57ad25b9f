// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/common_directions.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <optional>

#include "core/random.h"

namespace yorb {
namespace {

using Normals = Eigen::Matrix<float, Eigen::Dynamic, 3>;

constexpr size_t kMostDirections = 4;

/// The planes that no direction has explained yet.
struct Unexplained {
  Normals normals;
  Eigen::VectorXf weights;
};

Unexplained Collect(const std::vector<LinePlane>& planes, const std::vector<bool>& is_explained) {
  Unexplained left;
  const auto count = static_cast<Eigen::Index>(std::count(is_explained.begin(), is_explained.end(), false));
  left.normals.resize(count, 3);
  left.weights.resize(count);
  Eigen::Index row = 0;
  for (size_t i = 0; i < planes.size(); ++i) {
    if (is_explained[i]) continue;
    left.normals.row(row) = planes[i].normal.transpose();
    left.weights[row++] = planes[i].weight;
  }
  return left;
}

float WeightAlong(const Unexplained& left, const Eigen::Vector3f& direction) {
  return ((left.normals * direction).array().abs() < kParallel).select(left.weights.array(), 0.f).sum();
}

/// Every so many a row, so that enough are left to judge guesses by.
Unexplained SampleOf(const Unexplained& all) {
  constexpr Eigen::Index kEnough = 800;
  const Eigen::Index step = (all.normals.rows() + kEnough - 1) / kEnough,
                     count = (all.normals.rows() + step - 1) / step;
  Unexplained sample{Normals(count, 3), Eigen::VectorXf(count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    sample.normals.row(k) = all.normals.row(k * step);
    sample.weights[k] = all.weights[k * step];
  }
  return sample;
}

/// The best of directions in which two lines would both run.
Eigen::Vector3f Guess(const Unexplained& left, Random& random) {
  constexpr int kGuesses = 200;
  constexpr float kLeastSine = 0.1f;  // nearly one plane twice says nothing
  const auto count = static_cast<uint32_t>(left.normals.rows());
  Eigen::Vector3f best = Eigen::Vector3f::Zero();
  float most = 0;
  for (int k = 0; k < kGuesses; ++k) {
    const Eigen::Vector3f a = left.normals.row(random.Below(count)), b = left.normals.row(random.Below(count));
    Eigen::Vector3f direction = a.cross(b);
    const float sine = direction.norm();
    if (sine < kLeastSine) continue;
    direction /= sine;
    const float weight = WeightAlong(left, direction);
    if (weight > most) {
      most = weight;
      best = direction;
    }
  }
  return best;
}

/// The direction to which the planes near it are most nearly at right angles. Nothing where they are so much alike that
/// it could as well run otherwise.
std::optional<Eigen::Vector3d> Refine(const Unexplained& left, const Eigen::Vector3f& guess) {
  constexpr int kRounds = 5;
  constexpr double kLeastSpread = 0.03;  // the normals fill 10 degrees
  Eigen::Vector3f direction = guess;
  double spread = 0;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::ArrayXf sines = (left.normals * direction).array();
    const Eigen::ArrayXf weights =
        (sines.abs() < 2 * kParallel).select(left.weights.array() / (1 + (sines / (0.5f * kParallel)).square()), 0.f);
    const Eigen::Matrix3f scatter = left.normals.transpose() * weights.matrix().asDiagonal() * left.normals;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter.cast<double>());
    direction = axes.eigenvectors().col(0).cast<float>();
    spread = axes.eigenvalues()[1] / axes.eigenvalues().sum();
  }
  if (!(spread >= kLeastSpread)) return std::nullopt;
  return direction.cast<double>().normalized();
}

}  // namespace

std::vector<Eigen::Vector3d> CommonDirections(const std::vector<LinePlane>& planes) {
  constexpr float kLeastShare = 0.1f;
  std::vector<Eigen::Vector3d> directions;
  std::vector<bool> is_explained(planes.size(), false);
  float total = 0;
  for (const LinePlane& plane : planes) total += plane.weight;
  Random random(0);
  while (directions.size() < kMostDirections) {
    const Unexplained left = Collect(planes, is_explained);
    if (left.normals.rows() < 2) break;
    const Eigen::Vector3f guess = Guess(SampleOf(left), random);
    if (!(WeightAlong(left, guess) >= kLeastShare * total)) break;
    const auto direction = Refine(left, guess);
    if (direction) directions.push_back(*direction);
    const Eigen::Vector3f along = direction ? Eigen::Vector3f(direction->cast<float>()) : guess;
    for (size_t i = 0; i < planes.size(); ++i) {
      if (std::abs(planes[i].normal.dot(along)) < 2 * kParallel) is_explained[i] = true;
    }
  }
  return directions;
}

}  // namespace yorb

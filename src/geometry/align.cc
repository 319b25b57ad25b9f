// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/align.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace yorb {
namespace {

/// Movement below so many metres, or below this share of the distance from the origin, is rounding.
constexpr double kStillM = 1e-8, kStill = 1e-14;
/// Width over length below which points count as a line: it turns the cloud by more than its own noise would show.
constexpr double kThin = 1e-4;

Eigen::Vector3d Centroid(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) sum += point;
  return points.empty() ? sum : Eigen::Vector3d(sum / static_cast<double>(points.size()));
}

/// The mean of a * b^T about the centroids.
Eigen::Matrix3d Covariance(const std::vector<Eigen::Vector3d>& a, const Eigen::Vector3d& a_centroid,
                           const std::vector<Eigen::Vector3d>& b, const Eigen::Vector3d& b_centroid) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - a_centroid) * (b[i] - b_centroid).transpose();
  return sum / static_cast<double>(a.size());
}

AlignDegeneracy ShapeOf(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& centroid) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d spread = solver.eigenvalues().cwiseMax(0).cwiseSqrt();  // rising
  if (spread(2) <= std::max(kStillM, kStill * centroid.norm())) return AlignDegeneracy::kOnePlace;
  return spread(1) <= kThin * spread(2) ? AlignDegeneracy::kLine : AlignDegeneracy::kNone;
}

AlignDegeneracy Worse(AlignDegeneracy a, AlignDegeneracy b) {
  for (const AlignDegeneracy kind : {AlignDegeneracy::kOnePlace, AlignDegeneracy::kLine}) {
    if (a == kind || b == kind) return kind;
  }
  return AlignDegeneracy::kNone;
}

}  // namespace

Alignment AlignPoints(const std::vector<Eigen::Vector3d>& source, const std::vector<Eigen::Vector3d>& target,
                      AlignMode mode) {
  YORB_CHECK(source.size() == target.size(), "points to align come in pairs");
  Alignment result;
  result.degeneracy = AlignDegeneracy::kTooFew;
  if (source.empty()) return result;
  const Eigen::Vector3d source_centroid = Centroid(source), target_centroid = Centroid(target);
  const Eigen::Matrix3d spread = Covariance(source, source_centroid, source, source_centroid);
  const AlignDegeneracy shape =
      Worse(ShapeOf(spread, source_centroid),
            ShapeOf(Covariance(target, target_centroid, target, target_centroid), target_centroid));
  if (shape != AlignDegeneracy::kOnePlace) {
    // Umeyama's equations (38) to (43).
    const Eigen::Matrix3d covariance = Covariance(target, target_centroid, source, source_centroid);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const bool is_mirrored = svd.matrixU().determinant() * svd.matrixV().determinant() < 0;
    const Eigen::Vector3d sign(1, 1, is_mirrored ? -1 : 1);
    result.rotation = Eigen::Quaterniond(svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose()).normalized();
    if (mode == AlignMode::kSimilarity) result.scale = svd.singularValues().dot(sign) / spread.trace();
  }
  result.translation = target_centroid - result.scale * (result.rotation * source_centroid);
  if (source.size() >= 3) result.degeneracy = shape;
  return result;
}

}  // namespace yorb

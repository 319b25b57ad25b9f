// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "geometry/rigid3.h"

namespace yorb {

/// What may differ between two lists of points besides noise.
enum class AlignMode {
  kRigid,       ///< a rigid motion, SE(3)
  kSimilarity,  ///< a rigid motion and a scale, Sim(3)
};

/// Why an alignment is not the only one that fits. The residuals are right all the same.
enum class AlignDegeneracy {
  kNone,
  kTooFew,    ///< fewer than three points
  kOnePlace,  ///< one of the lists stays in one place: the rotation is any, a scale stays 1
  kLine,      ///< one of the lists lies on a line: the turn about it is any
};

/// `x_in_target = scale * rotation * x_in_source + translation`.
struct Alignment {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  double scale = 1;
  AlignDegeneracy degeneracy = AlignDegeneracy::kNone;

  Eigen::Vector3d operator*(const Eigen::Vector3d& x_in_source) const {
    return scale * (rotation * x_in_source) + translation;
  }

  /// A pose in the source's world as one in the target's.
  Rigid3 operator*(const Rigid3& source_from_cam) const {
    return {rotation * source_from_cam.rotation, *this * source_from_cam.translation};
  }
};

/// The least-squares alignment of paired points (Umeyama, 1991). Both lists are equally long and finite; the answer is
/// finite always, also where `degeneracy` says that others fit as well.
Alignment AlignPoints(const std::vector<Eigen::Vector3d>& source, const std::vector<Eigen::Vector3d>& target,
                      AlignMode mode);

}  // namespace yorb

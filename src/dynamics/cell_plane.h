// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>

#include "dynamics/depth_cells.h"

namespace yorb {

/// A plane as a pinhole camera sees it: its inverse depth is an affine function of the place in the picture.
struct CellPlane {
  Eigen::Vector3f inverse_depth = Eigen::Vector3f::Zero();  ///< 1/m: at column 0 and row 0; for each column; each row

  /// 1/m; zero or negative where the plane is not seen.
  float InverseDepthAt(int column, int row) const {
    return inverse_depth.dot(Eigen::Vector3f(1, static_cast<float>(column), static_cast<float>(row)));
  }
  /// Metres; infinite or negative where the plane is not seen.
  float DepthAt(int column, int row) const { return 1 / InverseDepthAt(column, row); }
};

/// The plane through measured cells of a range, by least squares of inverse depth. It counts from the middle of the
/// range, with half its size as one, so that floats do.
class CellPlaneFit {
 public:
  explicit CellPlaneFit(const CellRange& range);

  /// How far a column is from the middle: -1 to 1 within the range.
  float Across(int column) const { return (static_cast<float>(column) - middle_.x()) / half_.x(); }
  void Add(int column, int row, float metres, float weight = 1);

  /// The sum of the weights.
  float weight() const { return squares_(0, 0); }

  /// The plane; `stiffness`, a share of the weight, holds it upright where little says how it is tilted. From one
  /// column to the next its inverse depth changes by no more than `most_turned` of that in the middle. Only after
  /// something was added.
  CellPlane Solve(float stiffness, float most_turned = std::numeric_limits<float>::infinity()) const;

 private:
  Eigen::Vector2f middle_, half_;
  Eigen::Matrix3f squares_ = Eigen::Matrix3f::Zero();
  Eigen::Vector3f products_ = Eigen::Vector3f::Zero();
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

namespace yorb {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Which 6x6 blocks of a symmetric matrix occur, in the upper half: row <= column. The first `size` slots are the
/// diagonal, in order.
struct BlockPattern {
  uint32_t size = 0;  ///< block rows
  std::vector<std::pair<uint32_t, uint32_t>> blocks;
};

/// The linear system that remains for the poses once the points are eliminated: `matrix * x = right`.
struct ReducedSystem {
  BlockPattern pattern;
  std::vector<Matrix6d> blocks;  ///< a row an entry of `pattern.blocks`; of diagonal blocks the upper half counts
  std::vector<Vector6d> right;
};

/// Solves reduced systems of one pattern, without allocating anything from one to the next.
class ReducedSolver {
 public:
  ReducedSolver() = default;
  explicit ReducedSolver(const BlockPattern& pattern);

  /// False when the matrix is not positive definite or the solution not finite; else `Solution` holds it.
  bool Solve(const ReducedSystem& system);

  Eigen::Map<const Vector6d> Solution(uint32_t row) const { return Eigen::Map<const Vector6d>(&solution_[6 * row]); }

 private:
  Eigen::MatrixXd dense_;
  Eigen::VectorXd solution_;
};

}  // namespace yorb

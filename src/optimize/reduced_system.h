// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "optimize/block_cholesky.h"

namespace yorb {

/// The linear system that remains for the poses once the points are eliminated: `matrix * x = right`.
struct ReducedSystem {
  BlockPattern pattern;
  std::vector<Matrix6d> blocks;  ///< a row an entry of `pattern.blocks`; of diagonal blocks the upper half counts
  std::vector<Vector6d> right;
};

/// Solves reduced systems of one pattern: dense for a neighbourhood of keyframes, sparse for a large map of which most
/// keyframes see nothing in common. The dense way allocates nothing from one system to the next.
class ReducedSolver {
 public:
  ReducedSolver() = default;
  explicit ReducedSolver(const BlockPattern& pattern);

  /// False when the matrix is not positive definite or the solution not finite; else `Solution` holds it.
  bool Solve(const ReducedSystem& system);

  Eigen::Map<const Vector6d> Solution(uint32_t row) const { return Eigen::Map<const Vector6d>(&solution_[6 * row]); }

  bool IsSparse() const { return factor_.has_value(); }

 private:
  bool SolveDense(const ReducedSystem& system);

  Eigen::MatrixXd dense_;
  std::optional<BlockCholesky> factor_;
  Eigen::VectorXd solution_;
};

}  // namespace yorb

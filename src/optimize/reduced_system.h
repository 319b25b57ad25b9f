// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace yorb {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Which 6x6 blocks of a symmetric matrix occur, in the upper half: row <= column. The first `size` are the diagonal,
/// the others follow by row and then by column.
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

/// Solves reduced systems of one pattern: dense for a neighbourhood of keyframes, sparse for a large map of which most
/// keyframes see nothing in common. The dense way allocates nothing from one system to the next.
class ReducedSolver {
 public:
  ReducedSolver() = default;
  explicit ReducedSolver(const BlockPattern& pattern);

  /// False when the matrix is not positive definite or the solution not finite; else `Solution` holds it.
  bool Solve(const ReducedSystem& system);

  Eigen::Map<const Vector6d> Solution(uint32_t row) const { return Eigen::Map<const Vector6d>(&solution_[6 * row]); }

  bool IsSparse() const { return factor_ != nullptr; }

 private:
  using SparseFactor = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower>;

  void MakeSparse(const BlockPattern& pattern);
  bool SolveDense(const ReducedSystem& system);
  bool SolveSparse(const ReducedSystem& system);

  Eigen::MatrixXd dense_;
  Eigen::SparseMatrix<double> sparse_;  // the lower half
  std::unique_ptr<SparseFactor> factor_;
  Eigen::VectorXd solution_;
};

}  // namespace yorb

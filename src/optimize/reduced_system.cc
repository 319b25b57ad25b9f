// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/reduced_system.h"

#include <Eigen/Cholesky>

namespace yorb {

ReducedSolver::ReducedSolver(const BlockPattern& pattern)
    : dense_(6 * pattern.size, 6 * pattern.size), solution_(6 * pattern.size) {}

bool ReducedSolver::Solve(const ReducedSystem& system) {
  if (system.pattern.size == 0) return true;
  dense_.setZero();
  for (size_t k = 0; k < system.blocks.size(); ++k) {
    const auto [row, column] = system.pattern.blocks[k];
    // The factorisation reads the lower half.
    dense_.block<6, 6>(6 * column, 6 * row) = system.blocks[k].transpose();
  }
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(dense_);  // in place
  if (factor.info() != Eigen::Success) return false;
  for (size_t row = 0; row < system.right.size(); ++row) solution_.segment<6>(6 * row) = system.right[row];
  factor.solveInPlace(solution_);
  return solution_.allFinite();
}

}  // namespace yorb

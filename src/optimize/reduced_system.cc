// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/reduced_system.h"

#include <Eigen/Cholesky>

namespace yorb {
namespace {

// Where the sparse factorisation, which goes number by number, overtakes the dense one, which goes by blocks.
constexpr uint32_t kSparseSize = 64;
constexpr double kSparseShare = 0.3;

bool ShouldBeSparse(const BlockPattern& pattern) {
  const double all = 0.5 * pattern.size * (pattern.size + 1.0);
  return pattern.size >= kSparseSize && static_cast<double>(pattern.blocks.size()) < kSparseShare * all;
}

}  // namespace

ReducedSolver::ReducedSolver(const BlockPattern& pattern) : solution_(6 * pattern.size) {
  if (ShouldBeSparse(pattern)) {
    factor_.emplace(pattern);
  } else {
    dense_.resize(6 * pattern.size, 6 * pattern.size);
  }
}

bool ReducedSolver::Solve(const ReducedSystem& system) {
  if (system.pattern.size == 0) return true;
  for (size_t row = 0; row < system.right.size(); ++row) {
    solution_.segment<6>(6 * static_cast<Eigen::Index>(row)) = system.right[row];
  }
  if (!factor_) return SolveDense(system) && solution_.allFinite();
  if (!factor_->Factorize(system.blocks)) return false;
  factor_->Solve(solution_);
  return solution_.allFinite();
}

bool ReducedSolver::SolveDense(const ReducedSystem& system) {
  dense_.setZero();
  for (size_t k = 0; k < system.blocks.size(); ++k) {
    const auto [row, column] = system.pattern.blocks[k];
    // The factorisation reads the lower half.
    dense_.block<6, 6>(6 * column, 6 * row) = system.blocks[k].transpose();
  }
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(dense_);  // in place
  if (factor.info() != Eigen::Success) return false;
  factor.solveInPlace(solution_);
  return true;
}

}  // namespace yorb

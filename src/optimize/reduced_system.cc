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
    MakeSparse(pattern);
  } else {
    dense_.resize(6 * pattern.size, 6 * pattern.size);
  }
}

bool ReducedSolver::Solve(const ReducedSystem& system) {
  if (system.pattern.size == 0) return true;
  for (size_t row = 0; row < system.right.size(); ++row) {
    solution_.segment<6>(6 * static_cast<Eigen::Index>(row)) = system.right[row];
  }
  return (IsSparse() ? SolveSparse(system) : SolveDense(system)) && solution_.allFinite();
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

void ReducedSolver::MakeSparse(const BlockPattern& pattern) {
  std::vector<Eigen::Triplet<double>> places;
  places.reserve(36 * pattern.blocks.size());
  for (const auto& [row, column] : pattern.blocks) {
    for (uint32_t i = 0; i < 6; ++i) {
      for (uint32_t j = row == column ? i : 0; j < 6; ++j) places.emplace_back(6 * column + j, 6 * row + i, 1.0);
    }
  }
  sparse_.resize(6 * pattern.size, 6 * pattern.size);
  sparse_.setFromTriplets(places.begin(), places.end());
  factor_ = std::make_unique<SparseFactor>();
  factor_->analyzePattern(sparse_);
}

bool ReducedSolver::SolveSparse(const ReducedSystem& system) {
  // A column of the lower half holds the rest of its diagonal block, then the other blocks of its block row in order.
  size_t next = system.pattern.size;
  double* value = sparse_.valuePtr();
  for (uint32_t row = 0; row < system.pattern.size; ++row) {
    size_t end = next;
    while (end < system.blocks.size() && system.pattern.blocks[end].first == row) ++end;
    for (int i = 0; i < 6; ++i) {
      for (int j = i; j < 6; ++j) *value++ = system.blocks[row](i, j);
      for (size_t k = next; k < end; ++k) {
        for (int j = 0; j < 6; ++j) *value++ = system.blocks[k](i, j);
      }
    }
    next = end;
  }
  factor_->factorize(sparse_);
  if (factor_->info() != Eigen::Success) return false;
  solution_ = factor_->solve(solution_).eval();
  return true;
}

}  // namespace yorb

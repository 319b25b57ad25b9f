// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/rigid3.h"

namespace yorb {

/// Which 6x6 blocks of a symmetric matrix occur, in the upper half: row <= column. The first `size` are the diagonal,
/// the others follow by row and then by column.
struct BlockPattern {
  uint32_t size = 0;  ///< block rows
  std::vector<std::pair<uint32_t, uint32_t>> blocks;
};

/// The Cholesky factor L L^T of sparse symmetric matrices of one pattern, in an order of rows that keeps it sparse
/// (approximate minimum degree). It goes by whole blocks, column by column, each gathering what earlier ones take from
/// it.
class BlockCholesky {
 public:
  explicit BlockCholesky(const BlockPattern& pattern);

  /// Of diagonal blocks the upper half counts. False where the matrix is not positive definite.
  bool Factorize(const std::vector<Matrix6d>& blocks);

  /// The solution in place of the right side; after a factorisation that worked.
  void Solve(Eigen::VectorXd& x) const;

  /// Blocks of the factor: those of the pattern, and what fills in.
  size_t num_blocks() const { return rows_.size(); }

 private:
  /// Where a block of the pattern goes in the factor.
  struct Source {
    uint32_t slot = 0;
    bool is_transposed = false;
  };

  void Order(const BlockPattern& pattern);
  void FindFill(const BlockPattern& pattern);
  void Scatter(const std::vector<Matrix6d>& blocks);
  bool FinishColumn(uint32_t column);

  std::vector<uint32_t> place_of_;      // of a row of the matrix, in the factor
  std::vector<uint32_t> column_begin_;  // in `rows_` and `values_`
  std::vector<uint32_t> rows_;          // of each column, rising; the first is the diagonal
  std::vector<Matrix6d> values_;
  std::vector<Source> sources_;  // a row a block of the pattern
};

}  // namespace yorb

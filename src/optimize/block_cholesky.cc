// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/block_cholesky.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace yorb {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

/// `c -= a * b^T`, the innermost work of all: two rows of `a` at a time stay in registers.
inline void SubtractProduct(const Matrix6d& a, const Matrix6d& b, Matrix6d& c) {
  using Pair = Eigen::Vector2d;
  for (int i = 0; i < 6; i += 2) {
    const Pair a0 = a.col(0).segment<2>(i), a1 = a.col(1).segment<2>(i), a2 = a.col(2).segment<2>(i);
    const Pair a3 = a.col(3).segment<2>(i), a4 = a.col(4).segment<2>(i), a5 = a.col(5).segment<2>(i);
    for (int j = 0; j < 6; ++j) {
      c.col(j).segment<2>(i) -=
          (a0 * b(j, 0) + a1 * b(j, 1) + a2 * b(j, 2)) + (a3 * b(j, 3) + a4 * b(j, 4) + a5 * b(j, 5));
    }
  }
}

/// The lower Cholesky factor in place of the lower half.
bool FactorInPlace(Matrix6d& m) {
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < j; ++k) m.col(j).tail(6 - j) -= m(j, k) * m.col(k).tail(6 - j);
    if (!(m(j, j) > 0) || !std::isfinite(m(j, j))) return false;
    m.col(j).tail(6 - j) *= 1.0 / std::sqrt(m(j, j));
  }
  return true;
}

/// `x = x * lower^-T`.
void DivideByTransposed(const Matrix6d& lower, const Vector6d& inverse_diagonal, Matrix6d& x) {
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < j; ++k) x.col(j) -= lower(j, k) * x.col(k);
    x.col(j) *= inverse_diagonal[j];
  }
}

}  // namespace

BlockCholesky::BlockCholesky(const BlockPattern& pattern) {
  Order(pattern);
  FindFill(pattern);
  values_.resize(rows_.size());
}

void BlockCholesky::Order(const BlockPattern& pattern) {
  std::vector<Eigen::Triplet<double>> places;
  places.reserve(2 * pattern.blocks.size());
  for (const auto& [row, column] : pattern.blocks) {
    places.emplace_back(row, column, 1.0);
    if (row != column) places.emplace_back(column, row, 1.0);
  }
  Eigen::SparseMatrix<double> graph(pattern.size, pattern.size);
  graph.setFromTriplets(places.begin(), places.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> row_at;
  Eigen::AMDOrdering<int>()(graph, row_at);
  place_of_.resize(pattern.size);
  for (uint32_t k = 0; k < pattern.size; ++k) place_of_[static_cast<uint32_t>(row_at.indices()[k])] = k;
}

void BlockCholesky::FindFill(const BlockPattern& pattern) {
  std::vector<std::vector<uint32_t>> columns(pattern.size);  // rows below the diagonal
  std::vector<std::vector<uint32_t>> children(pattern.size);
  for (const auto& [row, column] : pattern.blocks) {
    const auto [first, second] = std::minmax(place_of_[row], place_of_[column]);
    if (first != second) columns[first].push_back(second);
  }
  std::vector<uint32_t> seen_at(pattern.size, kNone);
  column_begin_ = {0};
  for (uint32_t k = 0; k < pattern.size; ++k) {
    std::vector<uint32_t>& rows = columns[k];
    for (const uint32_t row : rows) seen_at[row] = k;
    for (const uint32_t child : children[k]) {
      // What a column took from its first row below the diagonal, it takes from that row's column, too.
      for (uint32_t at = column_begin_[child] + 2; at < column_begin_[child + 1]; ++at) {
        if (seen_at[rows_[at]] == k) continue;
        seen_at[rows_[at]] = k;
        rows.push_back(rows_[at]);
      }
    }
    std::sort(rows.begin(), rows.end());
    if (!rows.empty()) children[rows.front()].push_back(k);
    rows_.push_back(k);
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    column_begin_.push_back(static_cast<uint32_t>(rows_.size()));
  }
  for (const auto& [row, column] : pattern.blocks) {
    const auto [first, second] = std::minmax(place_of_[row], place_of_[column]);
    const auto begin = rows_.begin() + column_begin_[first], end = rows_.begin() + column_begin_[first + 1];
    const auto slot = static_cast<uint32_t>(std::lower_bound(begin, end, second) - rows_.begin());
    // The block at (row, column) stands in the lower half as it is where its row comes later.
    sources_.push_back({slot, place_of_[row] <= place_of_[column]});
  }
}

void BlockCholesky::Scatter(const std::vector<Matrix6d>& blocks) {
  std::fill(values_.begin(), values_.end(), Matrix6d::Zero());
  for (size_t k = 0; k < blocks.size(); ++k) {
    if (sources_[k].is_transposed) {
      values_[sources_[k].slot] = blocks[k].transpose();
    } else {
      values_[sources_[k].slot] = blocks[k];
    }
  }
}

bool BlockCholesky::Factorize(const std::vector<Matrix6d>& blocks) {
  Scatter(blocks);
  const auto size = static_cast<uint32_t>(place_of_.size());
  std::vector<uint32_t> slot_of(size);       // in the present column, by row
  std::vector<uint32_t> at(size);            // where a finished column has its next row
  std::vector<uint32_t> first(size, kNone);  // the finished columns whose next row is this one, as a chain
  std::vector<uint32_t> next(size, kNone);
  const auto chain = [&](uint32_t column) {
    if (at[column] == column_begin_[column + 1]) return;
    next[column] = std::exchange(first[rows_[at[column]]], column);
  };
  for (uint32_t k = 0; k < size; ++k) {
    for (uint32_t slot = column_begin_[k]; slot < column_begin_[k + 1]; ++slot) slot_of[rows_[slot]] = slot;
    for (uint32_t column = first[k]; column != kNone;) {
      const Matrix6d& taken = values_[at[column]];
      for (uint32_t slot = at[column]; slot < column_begin_[column + 1]; ++slot) {
        SubtractProduct(values_[slot], taken, values_[slot_of[rows_[slot]]]);
      }
      ++at[column];
      const uint32_t following = next[column];
      chain(column);
      column = following;
    }
    if (!FinishColumn(k)) return false;
    at[k] = column_begin_[k] + 1;
    chain(k);
  }
  return true;
}

bool BlockCholesky::FinishColumn(uint32_t column) {
  Matrix6d& diagonal = values_[column_begin_[column]];
  if (!FactorInPlace(diagonal)) return false;
  const Vector6d inverse_diagonal = diagonal.diagonal().cwiseInverse();
  for (uint32_t slot = column_begin_[column] + 1; slot < column_begin_[column + 1]; ++slot) {
    DivideByTransposed(diagonal, inverse_diagonal, values_[slot]);
  }
  return true;
}

void BlockCholesky::Solve(Eigen::VectorXd& x) const {
  const auto size = static_cast<uint32_t>(place_of_.size());
  std::vector<Vector6d> y(size);
  for (uint32_t row = 0; row < size; ++row) y[place_of_[row]] = x.segment<6>(6 * row);
  for (uint32_t k = 0; k < size; ++k) {
    values_[column_begin_[k]].triangularView<Eigen::Lower>().solveInPlace(y[k]);
    for (uint32_t slot = column_begin_[k] + 1; slot < column_begin_[k + 1]; ++slot) {
      y[rows_[slot]].noalias() -= values_[slot] * y[k];
    }
  }
  for (uint32_t k = size; k-- > 0;) {
    for (uint32_t slot = column_begin_[k] + 1; slot < column_begin_[k + 1]; ++slot) {
      y[k].noalias() -= values_[slot].transpose() * y[rows_[slot]];
    }
    values_[column_begin_[k]].triangularView<Eigen::Lower>().transpose().solveInPlace(y[k]);
  }
  for (uint32_t row = 0; row < size; ++row) x.segment<6>(6 * row) = y[place_of_[row]];
}

}  // namespace yorb

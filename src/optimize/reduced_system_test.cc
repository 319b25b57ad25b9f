// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/reduced_system.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "core/random.h"

namespace yorb {
namespace {

Matrix6d RandomBlock(Random& random) {
  return Matrix6d::NullaryExpr([&](Eigen::Index, Eigen::Index) { return random.Uniform(-1, 1); });
}

/// A positive definite system in which each row is tied to the next `band` ones, and the first to the last.
ReducedSystem MakeSystem(uint32_t size, uint32_t band, double diagonal, Random& random) {
  ReducedSystem system;
  system.pattern.size = size;
  for (uint32_t k = 0; k < size; ++k) {
    system.pattern.blocks.emplace_back(k, k);
    const Matrix6d block = RandomBlock(random);
    system.blocks.push_back(block + block.transpose() + diagonal * Matrix6d::Identity());
    system.right.push_back(RandomBlock(random).col(0));
  }
  for (uint32_t row = 0; row < size; ++row) {
    for (uint32_t column = row + 1; column < size; ++column) {
      if (column - row > band && !(row == 0 && column == size - 1)) continue;
      system.pattern.blocks.emplace_back(row, column);
      system.blocks.push_back(RandomBlock(random));
    }
  }
  // Of diagonal blocks the upper half alone counts.
  for (uint32_t k = 0; k < size; ++k) system.blocks[k].triangularView<Eigen::StrictlyLower>().setConstant(1e9);
  return system;
}

/// The slow twin.
Eigen::VectorXd SolveFull(const ReducedSystem& system) {
  const Eigen::Index size = 6 * system.pattern.size;
  Eigen::MatrixXd upper = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right(size);
  for (size_t k = 0; k < system.blocks.size(); ++k) {
    upper.block<6, 6>(6 * system.pattern.blocks[k].first, 6 * system.pattern.blocks[k].second) = system.blocks[k];
  }
  for (size_t k = 0; k < system.right.size(); ++k) right.segment<6>(6 * static_cast<Eigen::Index>(k)) = system.right[k];
  const Eigen::MatrixXd full = upper.selfadjointView<Eigen::Upper>();
  return full.partialPivLu().solve(right);
}

TEST(ReducedSolver, SolvesDenseAndSparseAsTheSlowTwinDoes) {
  Random random(1);
  for (const auto& [size, band] : {std::pair<uint32_t, uint32_t>{1, 0}, {5, 4}, {70, 69}, {70, 5}, {100, 3}}) {
    const ReducedSystem first = MakeSystem(size, band, 20.0 * (band + 1), random);
    const ReducedSystem second = MakeSystem(size, band, 20.0 * (band + 1), random);
    ReducedSolver solver(first.pattern);
    EXPECT_EQ(solver.IsSparse(), size >= 70 && band <= 5);
    for (const ReducedSystem* system : {&first, &second}) {
      ASSERT_TRUE(solver.Solve(*system));
      const Eigen::VectorXd expected = SolveFull(*system);
      for (uint32_t k = 0; k < size; ++k) {
        EXPECT_LT((solver.Solution(k) - expected.segment<6>(6 * k)).norm(), 1e-12) << size << " " << k;
      }
    }
  }
}

TEST(ReducedSolver, SaysWhenAMatrixIsNotPositiveDefinite) {
  Random random(2);
  for (const uint32_t size : {4u, 100u}) {
    ReducedSystem system = MakeSystem(size, 2, 100, random);
    system.blocks[size / 2] -= 300 * Matrix6d::Identity();
    ReducedSolver solver(system.pattern);
    EXPECT_FALSE(solver.Solve(system));
    system.blocks[size / 2].setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(solver.Solve(system));
  }
}

TEST(ReducedSolver, HasNothingToDoForNoPose) {
  ReducedSolver solver{BlockPattern{}};
  EXPECT_TRUE(solver.Solve(ReducedSystem{}));
}

}  // namespace
}  // namespace yorb

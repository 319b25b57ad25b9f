// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/block_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <limits>

#include "core/random.h"

namespace yorb {
namespace {

struct BlockMatrix {
  BlockPattern pattern;
  std::vector<Matrix6d> blocks;

  Eigen::MatrixXd Full() const {
    Eigen::MatrixXd upper = Eigen::MatrixXd::Zero(6 * pattern.size, 6 * pattern.size);
    for (size_t k = 0; k < blocks.size(); ++k) {
      upper.block<6, 6>(6 * pattern.blocks[k].first, 6 * pattern.blocks[k].second) = blocks[k];
    }
    return upper.selfadjointView<Eigen::Upper>();
  }
};

Matrix6d RandomBlock(Random& random) {
  return Matrix6d::NullaryExpr([&](Eigen::Index, Eigen::Index) { return random.Uniform(-1, 1); });
}

/// Positive definite; each pair of rows is tied with the given probability.
BlockMatrix MakeMatrix(uint32_t size, double share, Random& random) {
  BlockMatrix m;
  m.pattern.size = size;
  for (uint32_t k = 0; k < size; ++k) {
    m.pattern.blocks.emplace_back(k, k);
    m.blocks.push_back(RandomBlock(random) + (8.0 + 8.0 * size * share) * Matrix6d::Identity());
    // The lower half does not count.
    m.blocks.back().triangularView<Eigen::StrictlyLower>().setConstant(1e9);
  }
  for (uint32_t row = 0; row < size; ++row) {
    for (uint32_t column = row + 1; column < size; ++column) {
      if (random.Uniform() >= share) continue;
      m.pattern.blocks.emplace_back(row, column);
      m.blocks.push_back(RandomBlock(random));
    }
  }
  return m;
}

TEST(BlockCholesky, SolvesAsTheDenseTwinDoesWhateverThePattern) {
  Random random(1);
  for (const uint32_t size : {1u, 2u, 7u, 40u}) {
    for (const double share : {0.0, 0.05, 0.3, 1.0}) {
      BlockMatrix m = MakeMatrix(size, share, random);
      BlockCholesky factor(m.pattern);
      for (int again = 0; again < 2; ++again) {
        const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(6 * size, -1, 2);
        ASSERT_TRUE(factor.Factorize(m.blocks));
        Eigen::VectorXd x = right;
        factor.Solve(x);
        EXPECT_LT((m.Full().ldlt().solve(right) - x).norm(), 1e-12 * size) << size << " " << share;
        for (Matrix6d& block : m.blocks) block *= 1.5;  // another matrix of the same pattern
      }
    }
  }
}

TEST(BlockCholesky, KeepsAChainAndAStarSparse) {
  // All rows are tied to the first: in that order the factor would be full. 400 rows full would take 35 MB and seconds.
  Random random(2);
  BlockMatrix star = MakeMatrix(400, 0, random);
  for (uint32_t k = 1; k < 400; ++k) {
    star.pattern.blocks.emplace_back(0, k);
    star.blocks.push_back(0.02 * RandomBlock(random));
  }
  BlockCholesky factor(star.pattern);
  EXPECT_EQ(factor.num_blocks(), 400u + 399u);
  EXPECT_TRUE(factor.Factorize(star.blocks));

  BlockPattern chain;
  chain.size = 400;
  for (uint32_t k = 0; k < 400; ++k) chain.blocks.emplace_back(k, k);
  for (uint32_t k = 0; k + 1 < 400; ++k) chain.blocks.emplace_back(k, k + 1);
  EXPECT_EQ(BlockCholesky(chain).num_blocks(), 400u + 399u);
}

TEST(BlockCholesky, SaysWhenAMatrixIsNotPositiveDefinite) {
  Random random(3);
  BlockMatrix m = MakeMatrix(20, 0.2, random);
  BlockCholesky factor(m.pattern);
  ASSERT_TRUE(factor.Factorize(m.blocks));
  const Matrix6d whole = m.blocks[11];
  m.blocks[11] -= 100 * Matrix6d::Identity();
  EXPECT_FALSE(factor.Factorize(m.blocks));
  m.blocks[11].setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(factor.Factorize(m.blocks));
  m.blocks[11].setConstant(std::numeric_limits<double>::infinity());
  EXPECT_FALSE(factor.Factorize(m.blocks));
  m.blocks[11] = whole;
  EXPECT_TRUE(factor.Factorize(m.blocks));
}

TEST(BlockCholesky, TakesTheEmptyMatrix) {
  BlockCholesky factor{BlockPattern{}};
  EXPECT_TRUE(factor.Factorize({}));
  Eigen::VectorXd x(0);
  factor.Solve(x);
}

}  // namespace
}  // namespace yorb

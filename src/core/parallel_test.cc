// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace yorb {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnceWhateverTheThreads) {
  for (const int num_threads : {-1, 0, 1, 2, 7}) {
    for (const size_t count : {size_t{0}, size_t{1}, size_t{3}, size_t{1000}}) {
      std::vector<int> visits(count, 0);
      ParallelFor(count, num_threads, [&](size_t i) { ++visits[i]; });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << num_threads << " threads";
    }
  }
}

TEST(ParallelFor, ThrowsTheBodysExceptionAgain) {
  const auto body = [](size_t i) {
    if (i == 5) throw std::runtime_error("five");
  };
  EXPECT_THROW(ParallelFor(100, 3, body), std::runtime_error);
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/prefetch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>

namespace yorb {
namespace {

TEST(Prefetch, GivesAllItemsInOrderAndThenNothing) {
  int made = 0;
  Prefetch<int> numbers([&]() -> std::optional<int> { return made < 100 ? std::optional<int>(made++) : std::nullopt; },
                        3);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(numbers.Next(), i);
  EXPECT_FALSE(numbers.Next().has_value());
  EXPECT_FALSE(numbers.Next().has_value());
}

TEST(Prefetch, MakesNoMoreAheadThanItMay) {
  std::atomic<int> made{0};
  Prefetch<std::unique_ptr<int>> numbers(
      [&]() -> std::optional<std::unique_ptr<int>> { return std::make_unique<int>(made++); }, 2);
  for (int taken = 1; taken <= 50; ++taken) {
    numbers.Next();
    EXPECT_LE(made.load(), taken + 3);
  }
}

TEST(Prefetch, EndsInTheMiddleOfAStreamWithoutEnd) {
  for (int run = 0; run < 50; ++run) {
    int made = 0;
    Prefetch<int> numbers([&]() -> std::optional<int> { return made++; }, 2);
    if (run % 2 == 1) {
      EXPECT_EQ(numbers.Next(), 0);
    }
  }
}

TEST(Prefetch, HandsOnWhatWasThrownAfterTheItemsBeforeIt) {
  int made = 0;
  Prefetch<int> numbers(
      [&]() -> std::optional<int> {
        if (made == 2) throw std::runtime_error("broken");
        return made++;
      },
      8);
  EXPECT_EQ(numbers.Next(), 0);
  EXPECT_EQ(numbers.Next(), 1);
  EXPECT_THROW(numbers.Next(), std::runtime_error);
}

}  // namespace
}  // namespace yorb

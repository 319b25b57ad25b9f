// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/latest.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace yorb {
namespace {

TEST(Latest, IsEmptyOrTheFirstValueAtFirst) {
  EXPECT_EQ(Latest<int>().Get(), nullptr);
  EXPECT_EQ(*Latest<int>(std::make_shared<const int>(4)).Get(), 4);
}

TEST(Latest, TheNewestWinsAndAHeldValueStays) {
  Latest<int> latest(std::make_shared<const int>(1));
  const auto held = latest.Get();
  latest.Set(std::make_shared<const int>(2));
  EXPECT_EQ(*latest.Get(), 2);
  EXPECT_EQ(*held, 1);
  EXPECT_EQ(held.use_count(), 1);  // nobody else keeps what was replaced
}

/// Takes the lock of the Latest that it is kept in when it dies.
struct Nosy {
  const Latest<Nosy>* keeper = nullptr;
  ~Nosy() {
    if (keeper) keeper->Get();
  }
};

TEST(Latest, OldValuesDieOutsideOfTheLock) {
  auto done = std::async(std::launch::async, [] {
    Latest<Nosy> latest;
    latest.Set(std::make_shared<const Nosy>(Nosy{}));
    auto nosy = std::make_shared<Nosy>();
    nosy->keeper = &latest;
    latest.Set(std::move(nosy));
    latest.Set(std::make_shared<const Nosy>(Nosy{}));  // the nosy one dies here and asks
    return true;
  });
  ASSERT_EQ(done.wait_for(std::chrono::seconds(30)), std::future_status::ready);
}

TEST(Latest, ReadersSeeWholeValuesThatNeverGoBack) {
  struct Pair {
    int number, square;
  };
  constexpr int kValues = 5000;
  Latest<Pair> latest(std::make_shared<const Pair>(Pair{0, 0}));
  std::vector<std::thread> readers;
  std::atomic<int> wrong{0};
  for (int r = 0; r < 3; ++r) {
    readers.emplace_back([&] {
      for (int last = 0; last < kValues;) {
        const auto pair = latest.Get();
        wrong += pair->square != pair->number * pair->number || pair->number < last;
        last = pair->number;
      }
    });
  }
  for (int i = 1; i <= kValues; ++i) latest.Set(std::make_shared<const Pair>(Pair{i, i * i}));
  for (auto& reader : readers) reader.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace yorb

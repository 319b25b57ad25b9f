// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/channel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

namespace yorb {
namespace {

using namespace std::chrono_literals;
constexpr auto kAWhile = 50ms;  // long enough for a thread that would not wait to be through

TEST(Channel, GivesItemsInTheirOrder) {
  Channel<int> channel(8);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(channel.Push(i));
  EXPECT_EQ(channel.Backlog(), 5u);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(channel.Pop(), i);
  EXPECT_EQ(channel.Backlog(), 0u);
}

TEST(Channel, GivesWhatIsInAfterTheEndAndThenNothing) {
  Channel<int> channel(8);
  EXPECT_TRUE(channel.Push(1));
  channel.Close();
  EXPECT_FALSE(channel.Push(2));
  EXPECT_FALSE(channel.TryPush(2));
  EXPECT_FALSE(channel.PushNow(2));
  EXPECT_EQ(channel.Pop(), 1);
  EXPECT_EQ(channel.Pop(), std::nullopt);
  EXPECT_EQ(channel.Pop(), std::nullopt);
  channel.Close();  // twice is fine
}

TEST(Channel, TryPushKeepsTheBoundAndPushNowGoesOverIt) {
  Channel<int> channel(1);
  EXPECT_TRUE(channel.TryPush(1));
  EXPECT_FALSE(channel.TryPush(2));
  EXPECT_TRUE(channel.PushNow(3));
  EXPECT_EQ(channel.Backlog(), 2u);
  EXPECT_EQ(channel.Pop(), 1);
  EXPECT_FALSE(channel.TryPush(4));  // still full: one item for a capacity of one
  EXPECT_EQ(channel.Pop(), 3);
  EXPECT_TRUE(channel.TryPush(5));
}

TEST(Channel, CarriesWhatCanOnlyBeMoved) {
  Channel<std::unique_ptr<int>> channel(1);
  EXPECT_TRUE(channel.Push(std::make_unique<int>(7)));
  EXPECT_EQ(**channel.Pop(), 7);
}

TEST(Channel, PushWaitsForRoom) {
  Channel<int> channel(1);
  EXPECT_TRUE(channel.Push(1));
  auto push = std::async(std::launch::async, [&] { return channel.Push(2); });
  EXPECT_EQ(push.wait_for(kAWhile), std::future_status::timeout);
  EXPECT_EQ(channel.Pop(), 1);
  EXPECT_TRUE(push.get());
  EXPECT_EQ(channel.Pop(), 2);
}

TEST(Channel, PopWaitsForAnItem) {
  Channel<int> channel(1);
  auto pop = std::async(std::launch::async, [&] { return channel.Pop(); });
  EXPECT_EQ(pop.wait_for(kAWhile), std::future_status::timeout);
  EXPECT_TRUE(channel.Push(3));
  EXPECT_EQ(pop.get(), 3);
}

TEST(Channel, PopWithinWaitsForAWhileOnly) {
  Channel<int> channel(1);
  EXPECT_EQ(channel.PopWithin(0.01), std::nullopt);
  EXPECT_EQ(channel.PopWithin(-1), std::nullopt);
  auto pop = std::async(std::launch::async, [&] { return channel.PopWithin(100); });
  EXPECT_EQ(pop.wait_for(kAWhile), std::future_status::timeout);
  EXPECT_TRUE(channel.Push(4));
  EXPECT_EQ(pop.get(), 4);
  auto in_vain = std::async(std::launch::async, [&] { return channel.PopWithin(100); });
  EXPECT_EQ(in_vain.wait_for(kAWhile), std::future_status::timeout);
  channel.Close();
  EXPECT_EQ(in_vain.get(), std::nullopt);
}

TEST(Channel, CloseWakesAllWhoWait) {
  Channel<int> empty(1), full(1);
  EXPECT_TRUE(full.Push(1));
  std::vector<std::future<bool>> waiting;
  for (int i = 0; i < 3; ++i) {
    waiting.push_back(std::async(std::launch::async, [&] { return empty.Pop().has_value(); }));
    waiting.push_back(std::async(std::launch::async, [&] { return full.Push(2); }));
  }
  EXPECT_EQ(waiting.front().wait_for(kAWhile), std::future_status::timeout);
  empty.Close();
  full.Close();
  for (auto& each : waiting) EXPECT_FALSE(each.get());
  EXPECT_EQ(full.Pop(), 1);
}

TEST(Channel, LosesAndDoublesNothingBetweenManyThreads) {
  constexpr int kWriters = 3, kReaders = 3, kItems = 3000;
  Channel<int> channel(4);
  std::vector<std::thread> writers, readers;
  std::vector<std::vector<int>> taken(kReaders);
  std::atomic<size_t> longest{0};
  for (int r = 0; r < kReaders; ++r) {
    readers.emplace_back([&, r] {
      while (const auto item = channel.Pop()) {
        taken[static_cast<size_t>(r)].push_back(*item);
        const size_t backlog = channel.Backlog();
        if (backlog > longest) longest = backlog;
      }
    });
  }
  for (int w = 0; w < kWriters; ++w) {
    writers.emplace_back([&, w] {
      for (int i = w; i < kItems; i += kWriters) EXPECT_TRUE(channel.Push(i));
    });
  }
  for (auto& writer : writers) writer.join();
  channel.Close();
  for (auto& reader : readers) reader.join();

  EXPECT_LE(longest, 4u);
  std::vector<int> all;
  for (const auto& part : taken) {
    // Each writer's numbers reach each reader in their order.
    for (int w = 0; w < kWriters; ++w) {
      std::vector<int> of_writer;
      std::copy_if(part.begin(), part.end(), std::back_inserter(of_writer), [w](int i) { return i % kWriters == w; });
      EXPECT_TRUE(std::is_sorted(of_writer.begin(), of_writer.end()));
    }
    all.insert(all.end(), part.begin(), part.end());
  }
  std::sort(all.begin(), all.end());
  std::vector<int> expected(kItems);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(all, expected);
}

TEST(Channel, ARingOfStagesCannotLock) {
  // The reader of `back` fills all of `forward` first: were `back` bounded, too, both would wait for ever.
  Channel<int> forward(1), back(1);
  std::thread stage([&] {
    while (const auto item = forward.Pop()) back.PushNow(*item + 1);
    back.Close();
  });
  int sum = 0;
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(forward.Push(i));
  forward.Close();
  while (const auto item = back.Pop()) sum += *item;
  stage.join();
  EXPECT_EQ(sum, 5050);
}

}  // namespace
}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace yorb {

/// A stream between two stages. `Push` waits while the stream is full, `TryPush` and `PushNow` never wait (the return
/// stream uses `PushNow`, so that no ring of stages can lock); `Pop` waits and gives nothing once the stream is
/// closed and drained, `PopWithin` after a while, too. Any thread may call anything.
template <typename T>
class Channel {
 public:
  explicit Channel(size_t capacity) : capacity_(capacity) {}

  /// Waits for room. False once the channel is closed: the item is dropped.
  bool Push(T item) {
    std::unique_lock<std::mutex> lock(mutex_);
    room_.wait(lock, [&] { return closed_ || items_.size() < capacity_; });
    return Put(std::move(item));
  }

  /// False when there is no room or the channel is closed: the item is dropped.
  bool TryPush(T item) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return items_.size() < capacity_ && Put(std::move(item));
  }

  /// Goes over the capacity rather than wait. False once the channel is closed.
  bool PushNow(T item) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return Put(std::move(item));
  }

  /// Waits for an item; nothing once closed and empty.
  std::optional<T> Pop() {
    std::unique_lock<std::mutex> lock(mutex_);
    ready_.wait(lock, [&] { return closed_ || !items_.empty(); });
    return Take();
  }

  /// Waits for an item for so long at most.
  std::optional<T> PopWithin(double seconds) {
    std::unique_lock<std::mutex> lock(mutex_);
    ready_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return closed_ || !items_.empty(); });
    return Take();
  }

  /// An item if there is one; never waits.
  std::optional<T> TryPop() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return Take();
  }

  /// No more items come in; those that are in can still be taken.
  void Close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    ready_.notify_all();
    room_.notify_all();
  }

  /// How many items wait.
  size_t Backlog() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return items_.size();
  }

 private:
  std::optional<T> Take() {
    if (items_.empty()) return std::nullopt;
    std::optional<T> item(std::move(items_.front()));
    items_.pop_front();
    room_.notify_one();
    return item;
  }

  bool Put(T&& item) {
    if (closed_) return false;
    items_.push_back(std::move(item));
    ready_.notify_one();
    return true;
  }

  const size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable ready_, room_;
  std::deque<T> items_;
  bool closed_ = false;
};

}  // namespace yorb

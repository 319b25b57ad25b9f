// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <thread>
#include <utility>

#include "core/channel.h"
#include "core/priority.h"

namespace yorb {

/// Makes items ahead of their use on a thread of its own, at most `ahead` of them and one in the making. `make` gives
/// nothing at the end; it is called by that thread alone, and no more once this object is gone.
template <typename T>
class Prefetch {
 public:
  Prefetch(std::function<std::optional<T>()> make, size_t ahead)
      : items_(ahead), thread_([this, work = std::move(make)] { Work(work); }) {}

  ~Prefetch() {
    items_.Close();
    thread_.join();
  }

  Prefetch(const Prefetch&) = delete;
  Prefetch& operator=(const Prefetch&) = delete;

  /// Waits for the next item, in the order in which they were made; nothing after the last one. What `make` threw is
  /// thrown here, after the items before it.
  std::optional<T> Next() {
    std::optional<T> item = items_.Pop();
    if (!item && failure_) std::rethrow_exception(failure_);  // written before Close, read after Pop saw it
    return item;
  }

 private:
  void Work(const std::function<std::optional<T>()>& make) {
    GiveWay(CanWait::kWhile);  // what is made lies ahead of its time
    try {
      while (std::optional<T> item = make()) {
        if (!items_.Push(*std::move(item))) break;
      }
    } catch (...) {
      failure_ = std::current_exception();
    }
    items_.Close();
  }

  Channel<T> items_;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace yorb {

/// How many threads the machine runs at once; at least one.
inline int NumHardwareThreads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

/// Calls `body(0)` ... `body(count - 1)`, each once, on up to `num_threads` threads (the caller's is one of them), and
/// returns when all are done. Which thread takes which index is open, so `body(i)` may only write what belongs to i.
/// The first exception ends the loop early and is thrown again here.
inline void ParallelFor(size_t count, int num_threads, const std::function<void(size_t)>& body) {
  std::atomic<size_t> next{0};
  std::mutex mutex;
  std::exception_ptr first_exception;
  const auto work = [&] {
    try {
      for (size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(mutex);
      if (!first_exception) first_exception = std::current_exception();
    }
  };
  std::vector<std::thread> helpers;
  const size_t num_helpers = std::min(count, static_cast<size_t>(std::max(1, num_threads)));
  for (size_t i = 1; i < num_helpers; ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  if (first_exception) std::rethrow_exception(first_exception);
}

}  // namespace yorb

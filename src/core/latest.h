// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace yorb {

/// The newest of a kind: one thread sets it, any thread reads it, nobody waits for long. What was read stays valid for
/// as long as the reader holds it.
template <typename T>
class Latest {
 public:
  explicit Latest(std::shared_ptr<const T> first = nullptr) : value_(std::move(first)) {}

  void Set(std::shared_ptr<const T> value) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      value_.swap(value);
    }
    // The old value dies here, outside of the lock: it may own a whole map.
  }

  std::shared_ptr<const T> Get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return value_;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const T> value_;
};

}  // namespace yorb

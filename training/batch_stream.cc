// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/batch_stream.h"

#include <algorithm>
#include <optional>

namespace yorb {
namespace {

constexpr int kAhead = 6;  // batches in all, for few threads

}  // namespace

BatchStream::BatchStream(const Loader& loader, int64_t first_step, int num_threads) {
  const auto ahead = static_cast<size_t>(std::max(2, kAhead / num_threads));
  for (int i = 0; i < num_threads; ++i) {
    const auto make = [own = loader, step = first_step + i, num_threads]() mutable {
      const int64_t now = step;
      step += num_threads;
      return std::optional<Batch>(own.Make(now));
    };
    makers_.push_back(std::make_unique<Prefetch<Batch>>(make, ahead));
  }
}

Batch BatchStream::Next() {
  std::optional<Batch> batch = makers_[turn_]->Next();
  turn_ = (turn_ + 1) % makers_.size();
  return *std::move(batch);
}

}  // namespace yorb

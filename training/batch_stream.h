// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/prefetch.h"
#include "training/batch.h"
#include "training/loader.h"

namespace yorb {

/// The batches of a training in the order of its steps, made ahead of their use by several threads that take turns.
/// What a batch holds does not depend on how many they are (see Loader).
class BatchStream {
 public:
  BatchStream(const Loader& loader, int64_t first_step, int num_threads);

  /// Waits for the batch of the next step. Throws what the making threw.
  Batch Next();

 private:
  std::vector<std::unique_ptr<Prefetch<Batch>>> makers_;  // the one at i makes every so many-th step from the i-th on
  size_t turn_ = 0;
};

}  // namespace yorb

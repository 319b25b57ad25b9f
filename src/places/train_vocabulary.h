// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/result.h"
#include "features/keypoint.h"
#include "places/vocabulary.h"

namespace yorb {

/// How a vocabulary is trained. The same pictures and options give the same bits, with any number of threads.
struct TrainingOptions {
  int branching = 20;    ///< children a node; from 2 to 255
  int levels = 4;        ///< of the tree, from 1; branching^levels words at most
  int64_t seed = 1;      ///< of where clusters begin
  int most_rounds = 12;  ///< of k-medians at each node
  int least_rows = 20;   ///< a node of fewer descriptors is told apart no further
  int num_threads = 1;   ///< that share the work
};

/// Told of the work so far (steps of all steps); asked whether to stop. Both may be empty; called by one thread.
struct TrainingHooks {
  std::function<void(size_t num_done, size_t num_all)> progress;
  std::function<bool()> should_stop;
};

/// Trains a vocabulary from the descriptors of pictures, one list a picture. Bad input where options are out of range,
/// or the pictures are too few or too poor to tell anything apart; failure where it was stopped.
Result<VocabularyPtr> TrainVocabulary(const std::vector<std::vector<Descriptor>>& pictures,
                                      const TrainingOptions& options, const TrainingHooks& hooks = {});

}  // namespace yorb

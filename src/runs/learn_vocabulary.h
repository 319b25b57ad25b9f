// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "features/orb_extractor.h"
#include "places/train_vocabulary.h"

namespace yorb {

/// How a vocabulary is learnt from pictures.
struct LearningOptions {
  size_t most_pictures = 5000;  ///< of more, so many at most are taken, evenly from first to last
  FeatureOptions features;      ///< as of the runs that will use it
  TrainingOptions training;
};

/// Told of the pictures read (of all, 0 where that is not known) and of the training after it; asked whether to stop.
struct LearningHooks {
  std::function<void(size_t num_done, size_t num_all)> on_pictures, on_training;
  std::function<bool()> should_stop;
};

/// What was learnt, and from how much.
struct LearntVocabulary {
  VocabularyPtr vocabulary;
  size_t num_pictures = 0, num_points = 0;
};

/// Learns a vocabulary from pictures, folders, videos and sequences. A picture that cannot be read is warned of and
/// left out; bad input where a path names nothing that is known, or all of it is too little.
Result<LearntVocabulary> LearnVocabulary(const std::vector<std::string>& paths, const LearningOptions& options,
                                         const LearningHooks& hooks = {});

}  // namespace yorb

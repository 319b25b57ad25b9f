// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/result.h"
#include "training/picture_set.h"

namespace yorb {

/// Pictures to learn from and pictures to measure on.
struct Split {
  std::vector<LabelledFile> train, val;
};

/// The parts of "4:1": so many to learn from for so many to measure on.
struct SplitRatio {
  int train = 4, val = 1;
};
Result<SplitRatio> ParseSplitRatio(const std::string& text);

/// Deals the files out by chance from a seed: the same files and seed give the same split.
Split SplitFiles(std::vector<LabelledFile> files, const SplitRatio& ratio, uint64_t seed);

}  // namespace yorb

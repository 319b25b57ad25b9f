// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "places/vocabulary.h"

namespace yorb {

/// Reads the text format of DBoW2, which ORBvoc.txt has: `branching levels scoring weighting`, then a node a line,
/// numbered from 1: its parent (0 is the root), 1 for a word or 0, the 32 bytes of its centre, its weight. Scoring and
/// weighting must be known there; here they are L1 and tf-idf with the file's weights. Bad input names `path` and line.
Result<VocabularyPtr> VocabularyFromText(const std::string& path, std::string_view text);

}  // namespace yorb

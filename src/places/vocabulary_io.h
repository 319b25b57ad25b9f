// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"
#include "places/vocabulary.h"

namespace yorb {

/// Reads a vocabulary: our own format, or the text format of DBoW2 (ORBvoc.txt), told apart by the content. Bad input
/// names the file, what is wrong, the line of a text, and the remedy.
Result<VocabularyPtr> ReadVocabulary(const std::string& path);

/// Whether a file begins as those of WriteVocabulary do.
bool BeginsAsVocabulary(const std::string& path);

/// Writes our own format, whole or not at all: 32 bytes a node and a checksum, so that reading takes milliseconds.
Status WriteVocabulary(const Vocabulary& vocabulary, const std::string& path);

}  // namespace yorb

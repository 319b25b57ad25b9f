// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/find_vocabulary.h"

#include <filesystem>
#include <string>

#include "core/installed.h"
#include "core/log.h"
#include "places/vocabulary_io.h"

namespace yorb {

namespace {

Result<VocabularyPtr> Read(const std::string& path) {
  auto vocabulary = ReadVocabulary(path);
  if (vocabulary) LogInfo("vocabulary " + path + ": " + std::to_string((*vocabulary)->num_words()) + " words");
  return vocabulary;
}

}  // namespace

Result<VocabularyPtr> FindVocabulary(const PlacesOptions& options) {
  if (!options.vocabulary.empty()) return Read(options.vocabulary);
  const auto folder = InstalledFolder("models");
  const std::string path = (std::filesystem::path(folder.value_or("models")) / "vocabulary.yvoc").string();
  std::error_code ignored;
  if (folder && std::filesystem::exists(path, ignored)) return Read(path);
  LogInfo(path + ", the vocabulary that comes with yorb, is not there: no place is recognised by its words");
  return VocabularyPtr();
}

}  // namespace yorb

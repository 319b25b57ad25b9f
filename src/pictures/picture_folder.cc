// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/picture_folder.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "pictures/endings.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> EntriesOf(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().filename().string().front() != '.') entries.push_back(entry->path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

void Collect(const fs::path& folder, std::set<fs::path>& seen, std::vector<std::string>& pictures) {
  std::error_code error;
  const fs::path place = fs::canonical(folder, error);
  if (error || !seen.insert(place).second) return;
  for (const fs::path& entry : EntriesOf(folder)) {
    std::error_code ignored;
    if (fs::is_directory(entry, ignored)) {
      Collect(entry, seen, pictures);
    } else if (HasPictureEnding(entry.filename().string())) {
      pictures.push_back(entry.string());
    }
  }
}

}  // namespace

std::vector<std::string> PicturesUnder(const std::string& folder) {
  std::set<fs::path> seen;
  std::vector<std::string> pictures;
  Collect(folder, seen, pictures);
  return pictures;
}

std::vector<std::string> PicturesIn(const std::string& folder) {
  std::vector<std::string> pictures;
  for (const fs::path& entry : EntriesOf(folder)) {
    std::error_code ignored;
    if (HasPictureEnding(entry.filename().string()) && !fs::is_directory(entry, ignored))
      pictures.push_back(entry.string());
  }
  return pictures;
}

}  // namespace yorb

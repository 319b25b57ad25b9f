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

void Collect(const fs::path& folder, std::set<fs::path>& seen, std::vector<std::string>& pictures) {
  std::error_code error;
  const fs::path place = fs::canonical(folder, error);
  if (error || !seen.insert(place).second) return;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    entries.push_back(entry->path());
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    const std::string name = entry.filename().string();
    if (name.front() == '.') continue;
    std::error_code ignored;
    if (fs::is_directory(entry, ignored)) {
      Collect(entry, seen, pictures);
    } else if (HasPictureEnding(name)) {
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

}  // namespace yorb

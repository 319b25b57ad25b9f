// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/picture_folder.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

#include "pictures/endings.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// The digits from `at` on, without the zeros before them; `at` goes on behind them.
std::string_view NumberAt(const std::string& name, size_t& at) {
  while (at < name.size() && name[at] == '0') ++at;
  const size_t begin = at;
  while (at < name.size() && IsDigit(name[at])) ++at;
  return std::string_view(name).substr(begin, at - begin);
}

/// Whether digits at `at` are decimals, as those of time stamps.
bool IsBehindPoint(const std::string& name, size_t at) {
  return at >= 2 && name[at - 1] == '.' && IsDigit(name[at - 2]);
}

/// Numbers in names count by their value: 2.png comes before 10.png, 0.25.png before 0.3.png. Names that differ in
/// zeros alone keep the order of their letters.
bool ComesBefore(const std::string& a, const std::string& b) {
  size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (IsDigit(a[i]) && IsDigit(b[k]) && !IsBehindPoint(a, i)) {
      const std::string_view left = NumberAt(a, i), right = NumberAt(b, k);
      if (left.size() != right.size()) return left.size() < right.size();
      if (left != right) return left < right;
    } else if (a[i] != b[k]) {
      return a[i] < b[k];
    } else {
      ++i, ++k;
    }
  }
  if ((i == a.size()) != (k == b.size())) return i == a.size();
  return a < b;
}

std::vector<fs::path> EntriesOf(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().filename().string().front() != '.') entries.push_back(entry->path());
  }
  std::sort(entries.begin(), entries.end(), [](const fs::path& a, const fs::path& b) {
    return ComesBefore(a.filename().string(), b.filename().string());
  });
  return entries;
}

using IsWanted = bool (*)(std::string_view name);

void Collect(const fs::path& folder, IsWanted is_wanted, std::set<fs::path>& seen, std::vector<std::string>& found) {
  std::error_code error;
  const fs::path place = fs::canonical(folder, error);
  if (error || !seen.insert(place).second) return;
  for (const fs::path& entry : EntriesOf(folder)) {
    std::error_code ignored;
    if (fs::is_directory(entry, ignored)) {
      Collect(entry, is_wanted, seen, found);
    } else if (is_wanted(entry.filename().string())) {
      found.push_back(entry.string());
    }
  }
}

}  // namespace

std::vector<std::string> PicturesUnder(const std::string& folder) {
  std::set<fs::path> seen;
  std::vector<std::string> pictures;
  Collect(folder, HasPictureEnding, seen, pictures);
  return pictures;
}

std::vector<std::string> VideosUnder(const std::string& folder) {
  std::set<fs::path> seen;
  std::vector<std::string> videos;
  Collect(folder, HasVideoEnding, seen, videos);
  return videos;
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

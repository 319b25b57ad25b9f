// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/picture_set.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace yorb {
namespace {

namespace fs = std::filesystem;

bool IsPicture(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  constexpr std::array<const char*, 5> kEndings{".jpg", ".jpeg", ".png", ".bmp", ".webp"};
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

std::string LabelsOf(const fs::path& picture) {
  if (const auto labels = FileBeside(picture.string(), "labels", ".txt")) return *labels;
  fs::path beside = picture;
  const std::string xml = beside.replace_extension(".xml").string();
  return fs::exists(xml) ? xml : beside.replace_extension(".txt").string();
}

}  // namespace

std::optional<std::string> FileBeside(const std::string& picture, const std::string& folder,
                                      const std::string& ending) {
  const fs::path path(picture);
  std::vector<fs::path> parts(path.begin(), path.end());
  const auto found = std::find(parts.rbegin(), parts.rend(), fs::path("images"));
  if (found == parts.rend()) return std::nullopt;
  *found = folder;
  fs::path other;
  for (const fs::path& part : parts) other /= part;
  return other.replace_extension(ending).string();
}

Result<std::vector<LabelledFile>> FindLabelledFiles(const std::string& folder) {
  std::error_code error;
  const auto options = fs::directory_options::follow_directory_symlink;
  std::vector<LabelledFile> files;
  fs::recursive_directory_iterator entry(folder, options, error);
  if (error) return BadInput(folder + ": is no folder that can be read (" + error.message() + ")");
  for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    if (IsPicture(path)) files.push_back({path.string(), LabelsOf(path), path.stem().string()});
    if (error) return BadInput(folder + ": cannot be read to its end (" + error.message() + ")");
  }
  if (files.empty()) return BadInput(folder + ": has no picture (jpg, jpeg, png, bmp, webp) in it");
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.picture < b.picture; });
  return files;
}

Result<std::string> FindClassList(const std::string& folder) {
  fs::path around = fs::absolute(folder);
  for (int up = 0; up < 4 && !around.empty(); ++up, around = around.parent_path()) {
    if (fs::exists(around / "classes.txt")) return (around / "classes.txt").string();
  }
  return BadInput(folder + ": no classes.txt in it or around it; name the list of classes with --class-list FILE");
}

}  // namespace yorb

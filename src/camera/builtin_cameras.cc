// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/builtin_cameras.h"

#include <algorithm>
#include <filesystem>

#include "camera/camera_io.h"
#include "core/installed.h"
#include "core/text.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> NamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() == ".yaml") names.push_back(at->path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

bool LooksLikeFile(const std::string& name) {
  std::error_code ignored;
  return name.find('/') != std::string::npos || fs::path(name).has_extension() || fs::exists(name, ignored);
}

}  // namespace

std::vector<std::string> BuiltinCameraNames() {
  const auto configs = InstalledFolder("configs");
  return configs ? NamesIn(fs::path(*configs) / "cameras") : std::vector<std::string>();
}

Result<std::string> FindConfigFile(const std::string& kind, const std::string& name) {
  const auto configs = InstalledFolder("configs");
  if (!configs) return Failure("the folder configs/ is not found beside the program; install it with the program");
  const fs::path folder = fs::path(*configs) / kind;
  const auto names = NamesIn(folder);
  if (std::find(names.begin(), names.end(), name) != names.end()) return (folder / (name + ".yaml")).string();
  return BadInput("'" + name + "' is not known among " + kind + "; known: " + Joined(names) +
                  (names.empty() ? "" : "; the nearest is " + NearestWord(name, names)));
}

Result<Rig> ReadCamera(const std::string& name_or_file) {
  const auto names = BuiltinCameraNames();
  const bool is_builtin = std::find(names.begin(), names.end(), name_or_file) != names.end();
  if (!is_builtin && LooksLikeFile(name_or_file)) {
    const std::string stem = fs::path(name_or_file).stem().string();
    std::error_code ignored;
    const bool is_meant = std::find(names.begin(), names.end(), stem) != names.end();
    if (!is_meant || fs::exists(name_or_file, ignored)) return ReadCameraFile(name_or_file);
    return BadInput(name_or_file + " does not exist; for the camera of that name give " + stem);
  }
  const auto path = FindConfigFile("cameras", name_or_file);
  if (path) return ReadCameraFile(*path);
  if (path.error().kind != Error::Kind::kBadInput) return path.error();
  return BadInput("camera '" + name_or_file + "' is neither a file nor a known name; known: " + Joined(names));
}

}  // namespace yorb

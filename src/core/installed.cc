// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/installed.h"

#include <filesystem>

namespace yorb {

namespace fs = std::filesystem;

std::optional<std::string> InstalledFolderFrom(const std::string& start, const std::string& name) {
  std::error_code ignored;
  for (fs::path at = fs::weakly_canonical(start, ignored); !at.empty(); at = at.parent_path()) {
    const fs::path shared =
        at / "share" / "yorb" / name;  // an installation, or a build folder with links of this shape
    if (fs::is_directory(shared, ignored)) return shared.string();
    const bool is_checkout = fs::exists(at / "src" / "LAYERS", ignored);
    if (is_checkout && fs::is_directory(at / name, ignored)) return (at / name).string();
    if (at == at.root_path()) break;
  }
  return std::nullopt;
}

namespace {

std::optional<fs::path> FolderOfProgram() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? std::nullopt : std::optional(program.parent_path());
}

}  // namespace

std::optional<std::string> InstalledFolder(const std::string& name) {
  const auto folder = FolderOfProgram();
  return folder ? InstalledFolderFrom(folder->string(), name) : std::nullopt;
}

std::optional<std::string> InstalledModuleFrom(const std::string& start, const std::string& file) {
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(start, ignored),
                 installed = folder.parent_path() / "lib" / "yorb" / file;
  if (fs::exists(installed, ignored)) return installed.string();
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path()) {
    const fs::path built = at / "lib" / "yorb" / file;
    if (fs::exists(at / "CMakeCache.txt", ignored) && fs::exists(built, ignored)) return built.string();
  }
  return std::nullopt;
}

std::optional<std::string> InstalledModule(const std::string& file) {
  const auto folder = FolderOfProgram();
  return folder ? InstalledModuleFrom(folder->string(), file) : std::nullopt;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/run_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <filesystem>
#include <system_error>

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFiles[] = {"config.yaml", "trajectory.txt", "keyframes.txt", "metrics.json",
                                  "frames.csv",  "log.txt",        "report.html"};

/// Why results cannot be written there: the user's to mend, but for a full disk.
Error Unusable(const std::string& path, int reason) {
  const std::string line = "results cannot be written to " + path + ": " + std::generic_category().message(reason);
  return reason == ENOSPC || reason == EDQUOT ? Failure(line) : BadInput(line + "; name another folder with --out");
}

/// Writes a small file and takes it away again; gives the system's reason where it could not.
int TryToWrite(const std::string& folder) {
  const std::string path = InRunFolder(folder, ".can_write_" + std::to_string(::getpid()));
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  int reason = ::write(file, "yorb\n", 5) == 5 ? 0 : errno;
  if (reason == 0 && ::fsync(file) != 0) reason = errno;
  if (::close(file) != 0 && reason == 0) reason = errno;
  ::unlink(path.c_str());
  return reason;
}

std::string DateAndTime() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  char text[32];
  const size_t length = std::strftime(text, sizeof(text), "%Y%m%d_%H%M%S", &local);
  return std::string(text, length);
}

}  // namespace

std::string InRunFolder(const std::string& folder, const std::string& file) {
  return (fs::path(folder) / file).string();
}

Status PrepareRunFolder(const std::string& folder) {
  if (folder.empty()) return BadInput("--out is empty; name a folder");
  std::error_code made, ignored;
  fs::create_directories(folder, made);
  if (!fs::is_directory(folder, ignored)) {
    return made ? Unusable(folder, made.value()) : Unusable(folder, ENOTDIR);
  }
  for (const char* name : kFiles) {
    if (fs::is_directory(InRunFolder(folder, name), ignored)) return Unusable(InRunFolder(folder, name), EISDIR);
  }
  const int reason = TryToWrite(folder);
  return reason == 0 ? Status::Ok() : Status(Unusable(folder, reason));
}

bool IsResultName(const std::string& name) {
  for (const char* fixed : kFiles) {
    if (name == fixed) return true;
  }
  std::string stem = fs::path(name).stem().string();
  const size_t bar = stem.find_last_not_of("0123456789");
  if (bar != std::string::npos && bar + 1 < stem.size() && stem[bar] == '_') stem.resize(bar);
  return fs::path(name).extension() == ".txt" && (stem == "trajectory" || stem == "keyframes");
}

Result<std::string> MakeDefaultRunFolder() {
  const std::string name = "yorb_" + DateAndTime();
  std::error_code error;
  for (int number = 1; number < 1000; ++number) {
    const std::string folder = number == 1 ? name : name + "_" + std::to_string(number);
    if (fs::create_directory(folder, error)) return folder;  // false where it is there already: another run's
    if (error) return Unusable(folder, error.value());
  }
  return Unusable(name, EEXIST);
}

std::string NumberedPath(const std::string& path, size_t number) {
  if (number == 1) return path;
  fs::path numbered(path);
  const std::string name = numbered.stem().string() + "_" + std::to_string(number) + numbered.extension().string();
  return numbered.replace_filename(name).string();
}

std::vector<std::string> OlderFiles(const std::string& path, const std::vector<FileToWrite>& written,
                                    size_t num_submaps) {
  std::vector<std::string> older;
  std::error_code ignored;
  for (size_t number = 2;; ++number) {
    const std::string further = NumberedPath(path, number);
    const auto is_it = [&](const FileToWrite& file) { return file.path == further; };
    if (std::any_of(written.begin(), written.end(), is_it)) continue;
    if (fs::is_regular_file(further, ignored)) {
      older.push_back(further);
    } else if (number > num_submaps) {
      return older;
    }
  }
}

}  // namespace yorb

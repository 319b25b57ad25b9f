// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/check.h"

namespace yorb {
namespace {

bool WriteAll(int file, const std::string& content) {
  for (size_t done = 0; done < content.size();) {
    const ssize_t count = ::write(file, content.data() + done, content.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<size_t>(count);
  }
  return true;
}

std::string DraftOf(const std::string& path) { return path + ".part"; }

enum class ToDisk { kForced, kInTime };

Status WriteDraft(const FileToWrite& target, ToDisk to_disk) {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::path(target.path).parent_path();
  if (!parent.empty()) std::filesystem::create_directories(parent, error);

  const std::string draft = DraftOf(target.path);
  const int file = ::open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return CannotWrite(target.path, errno);
  const bool is_written = WriteAll(file, target.content) && (to_disk == ToDisk::kInTime || ::fsync(file) == 0);
  const int reason = errno;
  if (::close(file) == 0 && is_written) return Status::Ok();
  const int why = is_written ? errno : reason;
  ::unlink(draft.c_str());
  return CannotWrite(target.path, why);
}

Status PutInPlace(const std::string& path) {
  const std::string draft = DraftOf(path);
  if (::rename(draft.c_str(), path.c_str()) == 0) return Status::Ok();
  const int reason = errno;
  ::unlink(draft.c_str());
  return CannotWrite(path, reason);
}

}  // namespace

Error CannotWrite(const std::string& path, int reason) {
  return Failure(path + " cannot be written: " + std::generic_category().message(reason));
}

Status WriteFileWhole(const std::string& path, const std::string& content) {
  return WriteFilesTogether({{path, content}});
}

Status WriteFileQuickly(const std::string& path, const std::string& content) {
  const Status status = WriteDraft({path, content}, ToDisk::kInTime);
  return status ? PutInPlace(path) : status;
}

Status WriteFilesTogether(const std::vector<FileToWrite>& files) {
  std::set<std::string> paths;
  for (const FileToWrite& file : files)
    YORB_CHECK(paths.insert(file.path).second, ("two files of one path: " + file.path).c_str());
  for (size_t i = 0; i < files.size(); ++i) {
    Status status = WriteDraft(files[i], ToDisk::kForced);
    if (status) continue;
    for (size_t k = 0; k < i; ++k) ::unlink(DraftOf(files[k].path).c_str());
    return status;
  }
  Status first = Status::Ok();
  for (const FileToWrite& file : files) {
    Status status = PutInPlace(file.path);
    if (first && !status) first = std::move(status);
  }
  return first;
}

std::string UntakenPath(const std::string& path, const std::function<bool(const std::string&)>& is_taken) {
  const std::filesystem::path first = path;
  std::string untaken = path;
  for (int number = 2; is_taken(untaken); ++number) {
    const std::string name = first.stem().string() + "_" + std::to_string(number) + first.extension().string();
    untaken = (first.parent_path() / name).string();
  }
  return untaken;
}

std::string UntakenPath(const std::string& path, std::set<std::string>& taken) {
  return UntakenPath(path, [&](const std::string& untaken) { return !taken.insert(untaken).second; });
}

std::string OwnName(const std::string& path) {
  std::error_code error;
  std::filesystem::path whole = std::filesystem::absolute(path, error).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();
  return error || !whole.has_filename() ? path : whole.filename().string();
}

}  // namespace yorb

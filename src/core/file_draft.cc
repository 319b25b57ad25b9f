// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/file_draft.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/files.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

/// Where the bytes go in the end: the target of a symbolic link, else the path itself.
std::string TargetOf(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}

}  // namespace

/// The open file. Copies of the draft share it, and the last one to go takes away what was not committed.
struct FileDraft::Handle {
  std::string path, target;  ///< as the caller names it, and where it really is
  int file = -1;

  std::string Part() const { return target + ".part"; }
  ~Handle() {
    if (file < 0) return;
    ::close(file);
    ::unlink(Part().c_str());
  }
};

Result<FileDraft> FileDraft::Open(const std::string& path) {
  auto handle = std::make_shared<Handle>();
  handle->path = path;
  handle->target = TargetOf(path);
  std::error_code ignored;
  // A folder cannot be replaced by a file, and a device must not be.
  if (fs::exists(handle->target, ignored) && !fs::is_regular_file(handle->target, ignored)) {
    return BadInput(path + " is no file that can be replaced; name another one");
  }
  const fs::path parent = fs::path(handle->target).parent_path();
  if (!parent.empty()) fs::create_directories(parent, ignored);
  handle->file = ::open(handle->Part().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (handle->file < 0) return CannotWrite(path, errno);
  return FileDraft(std::move(handle));
}

Status FileDraft::Append(const char* bytes, size_t count) {
  for (size_t done = 0; done < count;) {
    const ssize_t written = ::write(handle_->file, bytes + done, count - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return CannotWrite(handle_->path, written < 0 ? errno : ENOSPC);
    done += static_cast<size_t>(written);
  }
  return Status::Ok();
}

Status FileDraft::Commit() {
  const std::shared_ptr<Handle> handle = std::move(handle_);
  if (::fsync(handle->file) != 0) return CannotWrite(handle->path, errno);
  const int closed = ::close(std::exchange(handle->file, -1));
  int reason = closed == 0 ? 0 : errno;
  if (reason == 0 && ::rename(handle->Part().c_str(), handle->target.c_str()) != 0) reason = errno;
  if (reason == 0) return Status::Ok();
  ::unlink(handle->Part().c_str());
  return CannotWrite(handle->path, reason);
}

}  // namespace yorb

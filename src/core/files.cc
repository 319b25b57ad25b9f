// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace yorb {
namespace {

Status CannotWrite(const std::string& path, int reason) {
  return Failure(path + " cannot be written: " + std::strerror(reason));
}

bool WriteAll(int file, const std::string& content) {
  for (size_t done = 0; done < content.size();) {
    const ssize_t count = ::write(file, content.data() + done, content.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<size_t>(count);
  }
  return true;
}

}  // namespace

Status WriteFileWhole(const std::string& path, const std::string& content) {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::path(path).parent_path();
  if (!parent.empty()) std::filesystem::create_directories(parent, error);

  const std::string draft = path + ".part";
  const int file = ::open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return CannotWrite(path, errno);
  const bool written = WriteAll(file, content) && ::fsync(file) == 0;
  const int reason = errno;
  if (::close(file) != 0 || !written) {
    ::unlink(draft.c_str());
    return CannotWrite(path, written ? errno : reason);
  }
  if (::rename(draft.c_str(), path.c_str()) != 0) {
    const int why = errno;
    ::unlink(draft.c_str());
    return CannotWrite(path, why);
  }
  return Status::Ok();
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "core/result.h"

namespace yorb {

/// A file that is written piece by piece beside its place and put there once it is whole: for content too large to be
/// held in memory. Until Commit a reader, a crash or a full disk sees the old file; a draft that is let go before
/// leaves nothing behind. Behind a symbolic link it is the link's target that is replaced.
class FileDraft {
 public:
  /// Makes missing parent folders. Failure names the file and the system's reason.
  static Result<FileDraft> Open(const std::string& path);

  Status Append(const char* bytes, size_t count);

  /// Everything on the disk, then the file in its place. The draft is done with, whatever comes of it.
  Status Commit();

 private:
  struct Handle;
  explicit FileDraft(std::shared_ptr<Handle> handle) : handle_(std::move(handle)) {}
  std::shared_ptr<Handle> handle_;
};

}  // namespace yorb

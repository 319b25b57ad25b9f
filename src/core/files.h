// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/result.h"

namespace yorb {

/// The failure to write a file for a reason of the system, an errno.
Error CannotWrite(const std::string& path, int reason);

/// Writes `content` beside `path` and renames it into place, so that a reader, a crash or a full disk sees the old
/// file or the new one, whole. Missing parent folders are made. Failure names the file and the system's reason.
Status WriteFileWhole(const std::string& path, const std::string& content);

/// The same for one of many files that can be made again, such as pictures of frames: not forced to the disk, so that a
/// power cut may take it.
Status WriteFileQuickly(const std::string& path, const std::string& content);

/// A path for one more file: `path` itself, or with a number behind its stem, a/x_2.jpg, where that is among `taken`;
/// what it gives is taken from then on.
std::string UntakenPath(const std::string& path, std::set<std::string>& taken);

/// The first of these names that is not taken, whatever that means.
std::string UntakenPath(const std::string& path, const std::function<bool(const std::string&)>& is_taken);

/// A file's or folder's own name, whatever its path looks like: "a" for "b/../a/", that of the current folder for ".".
std::string OwnName(const std::string& path);

/// One file to be written.
struct FileToWrite {
  std::string path;
  std::string content;
};

/// Writes several files that belong together: none is put in its place before all of them could be written, so that a
/// full disk leaves the old ones as they were. Their paths must differ.
Status WriteFilesTogether(const std::vector<FileToWrite>& files);

}  // namespace yorb

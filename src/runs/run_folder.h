// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/files.h"
#include "core/result.h"

namespace yorb {

/// Makes sure, before any work is done, that results can be written into `folder`: makes it with its parents, and tries
/// to write. What an older run left in it stays untouched. Bad input where it cannot be used; a failure where the disk
/// is full.
Status PrepareRunFolder(const std::string& folder);

/// Makes a new folder "yorb_DATE_TIME" in the current one and gives its name.
Result<std::string> MakeDefaultRunFolder();

/// Whether a run writes, or takes away, a file of that name in its folder: trajectory_2.txt, too.
bool IsResultName(const std::string& name);

/// The files of a run folder, each with its folder before it.
std::string InRunFolder(const std::string& folder, const std::string& file);

/// The file of the sub-map with that number, from 1.
std::string NumberedPath(const std::string& path, size_t number);

/// The files beside `path` that an older result with other sub-maps may have left: numbered ones that are not among
/// those `written`, up to the first number beyond `num_submaps` that is not there.
std::vector<std::string> OlderFiles(const std::string& path, const std::vector<FileToWrite>& written,
                                    size_t num_submaps);

}  // namespace yorb

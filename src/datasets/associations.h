// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"
#include "datasets/picture_list.h"

namespace yorb {

/// What associations.txt holds: two lists of equal length, line by line.
struct Associations {
  PictureList colour, depth;
};

/// Reads lines of two pictures, each behind its time stamp. Which is depth shows in the names (or, where they do not
/// say, in the first pictures themselves), whatever the order; further columns are passed over. Bad input names file
/// and line.
Result<Associations> ReadAssociations(const std::string& path);

}  // namespace yorb

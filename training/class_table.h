// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace yorb {

/// The things that a network can name, in the order of its class outputs. A name stands for the same thing in every
/// set of pictures, whatever its number there.
struct ClassTable {
  std::vector<std::string> names;
  std::vector<std::string> motions;  ///< "high", "low" or "static"; empty texts where the file says nothing

  int size() const { return static_cast<int>(names.size()); }
  std::optional<int> Find(const std::string& name) const;
};

/// `text` without blanks, dashes and underscores, in small letters: how names of classes are compared.
std::string BareName(const std::string& text);

/// Reads lines `number name` or `number name motion`, the numbers running from 0; or bare names, one a line.
Result<ClassTable> ReadClassTable(const std::string& path);

}  // namespace yorb

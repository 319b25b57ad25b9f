// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"

namespace yorb {

/// Pictures that could not be read, told at the end, so that the others are done before.
class Unreadable {
 public:
  void Add(const Error& error);
  void Add(const Unreadable& others);

  size_t count() const { return count_; }

  /// Bad input that names the first few; fine where every picture could be read.
  Status Told() const;

 private:
  size_t count_ = 0;
  std::vector<std::string> first_;
};

}  // namespace yorb

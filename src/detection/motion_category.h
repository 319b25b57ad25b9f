// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "core/result.h"

namespace yorb {

/// How a kind of thing moves, as the paper sorts them.
enum class Motion {
  kStatic,  ///< rarely moves: tables, screens
  kLow,     ///< does not move by itself, but with those who do: chairs, cups
  kHigh,    ///< moves by itself: people, animals
};

/// "static", "low", "high".
std::string ToString(Motion motion);

/// Which class moves how, by name; case, blanks, underscores and hyphens do not count.
class MotionTable {
 public:
  /// The built-in table: COCO's classes and common things of rooms.
  static MotionTable Default();

  /// What the table says; static for a name that it does not know.
  Motion Of(const std::string& name) const;
  bool Knows(const std::string& name) const;

  void Set(const std::string& name, Motion motion);

 private:
  std::map<std::string, Motion> by_name_;  // by folded name
};

/// The built-in table with the lines of a file laid over it: `name motion` or `number name motion`, such as
/// "6 chair low" (models/classes.txt is one). Bad input names file and line.
Result<MotionTable> ReadMotionTable(const std::string& path);

/// The table of models/classes.txt of this installation, which users may edit; the built-in one where it is not there.
Result<MotionTable> InstalledMotionTable();

}  // namespace yorb

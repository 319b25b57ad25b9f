// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "core/stopwatch.h"

namespace yorb {

/// Shows on standard output how far a run has come: one line that is written over on a terminal, a line a quarter of
/// the way elsewhere, nothing when quiet.
class Progress {
 public:
  explicit Progress(bool is_quiet, std::string what = "frames");

  /// So many of so many are done.
  void Show(size_t num_done, size_t num_frames);

  /// Clears the line on a terminal, so that what follows stands alone.
  void End();

 private:
  void ShowOnTerminal(size_t num_done, size_t num_frames);

  bool is_quiet_, is_terminal_;
  std::string what_;
  Stopwatch watch_;
  double shown_s_ = -1;  // when a terminal's line was last written
  size_t quarters_shown_ = 0;
  bool is_line_open_ = false;
};

}  // namespace yorb

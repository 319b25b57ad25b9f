// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include "core/text.h"

namespace yorb {
namespace {

constexpr double kRedrawEveryS = 0.2;

}  // namespace

Progress::Progress(bool is_quiet, std::string what)
    : is_quiet_(is_quiet), is_terminal_(::isatty(STDOUT_FILENO) == 1), what_(std::move(what)) {}

void Progress::Show(size_t num_done, size_t num_frames) {
  if (is_quiet_ || num_frames == 0) return;
  if (is_terminal_) return ShowOnTerminal(num_done, num_frames);
  const size_t quarters = num_done * 4 / num_frames;
  if (quarters == quarters_shown_) return;
  quarters_shown_ = quarters;
  if (quarters == 4) return;  // the summary says it
  std::printf("%zu of %zu %s, %s s\n", num_done, num_frames, what_.c_str(), FormatFixed(watch_.seconds(), 1).c_str());
  std::fflush(stdout);
}

void Progress::ShowOnTerminal(size_t num_done, size_t num_frames) {
  const double now_s = watch_.seconds();
  if (now_s < shown_s_ + kRedrawEveryS) return;
  shown_s_ = now_s;
  is_line_open_ = true;
  const double rate = now_s > 0 ? static_cast<double>(num_done) / now_s : 0;
  std::printf("\r\033[K%zu of %zu %s (%zu %%), %s %s/s", num_done, num_frames, what_.c_str(),
              num_done * 100 / num_frames, FormatFixed(rate, 1).c_str(), what_.c_str());
  std::fflush(stdout);
}

void Progress::End() {
  if (is_line_open_) std::printf("\r\033[K");
  is_line_open_ = false;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/stop_signal.h"

#include <csignal>

namespace yorb {
namespace {

volatile std::sig_atomic_t stop_asked = 0;  // all that a signal handler may write

void Note(int) { stop_asked = 1; }

}  // namespace

void CatchStopSignals() {
  std::signal(SIGINT, Note);
  std::signal(SIGTERM, Note);
}

bool IsStopAsked() { return stop_asked != 0; }

}  // namespace yorb

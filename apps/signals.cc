// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/signals.h"

#include <csignal>

namespace yorb {
namespace {

volatile std::sig_atomic_t caught_signal = 0;

extern "C" void NoteSignal(int number) {
  if (caught_signal == 0) caught_signal = number;  // the first one decides on the exit code
}

void Catch(int number) {
  struct sigaction action {};
  action.sa_handler = NoteSignal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(number, &action, nullptr);
}

}  // namespace

void CatchSignals() {
  Catch(SIGINT);
  Catch(SIGTERM);
  struct sigaction hang_up {};
  sigaction(SIGHUP, nullptr, &hang_up);
  if (hang_up.sa_handler != SIG_IGN) Catch(SIGHUP);
}

bool IsStopAsked() { return caught_signal != 0; }

int ExitCodeAfterSignal(int otherwise) {
  if (caught_signal == 0) return otherwise;
  return 128 + (caught_signal == SIGINT ? SIGINT : SIGTERM);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

/// From now on SIGINT, SIGTERM and SIGHUP are noted instead of ending the program; what runs has to look. A hang-up
/// that is ignored already (nohup) stays ignored.
void CatchSignals();

/// Whether one was noted.
bool IsStopAsked();

/// The exit code after it: 130 for SIGINT, 143 for the others; `otherwise` where none was noted.
int ExitCodeAfterSignal(int otherwise);

}  // namespace yorb

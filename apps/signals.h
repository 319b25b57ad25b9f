// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

/// From now on SIGINT, SIGTERM and SIGHUP are noted instead of ending the program; what runs has to look. A hang-up
/// that is ignored already (nohup) stays ignored.
void CatchSignals();

/// The signal that was noted last; 0: none.
int CaughtSignal();

}  // namespace yorb

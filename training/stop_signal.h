// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

/// From now on SIGINT and SIGTERM are noted instead of ending the program.
void CatchStopSignals();

/// Whether one was noted.
bool IsStopAsked();

}  // namespace yorb

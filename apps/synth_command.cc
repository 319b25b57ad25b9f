// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/command.h"

namespace yorb {

void AddSynthCommand(CLI::App&, Action&) {}

}  // namespace yorb

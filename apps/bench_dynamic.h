// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/command.h"

namespace yorb {

/// `yorb bench dynamic`.
void AddBenchDynamic(CLI::App& bench, Action& action);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/command.h"

namespace yorb {

/// `yorb bench detector`, added to `bench`.
void AddBenchDetector(CLI::App& bench, Action& action);

}  // namespace yorb

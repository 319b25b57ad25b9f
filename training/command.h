// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "core/result.h"

namespace yorb {

using Action = std::function<Status()>;

void AddPackCommand(CLI::App& program, Action& action);
void AddTrainCommand(CLI::App& program, Action& action);
void AddEvaluateCommand(CLI::App& program, Action& action);
void AddExportCommand(CLI::App& program, Action& action);
void AddCurvesCommand(CLI::App& program, Action& action);
void AddTableCommand(CLI::App& program, Action& action);
void AddPeopleMapCommand(CLI::App& program, Action& action);

}  // namespace yorb

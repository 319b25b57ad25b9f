// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "core/result.h"

namespace yorb {

/// What the chosen subcommand does once all options are read; gives the exit code.
using Action = std::function<int()>;

/// Each subcommand stands in a file of its own, adds itself to the program with its options and an epilogue of
/// examples, and puts what it does into `action` when it is the chosen one (`command->callback([=, &action] { action =
/// ...; })`).
void AddRunCommand(CLI::App& program, Action& action);
void AddCheckCommand(CLI::App& program, Action& action);
void AddEvalCommand(CLI::App& program, Action& action);
void AddSynthCommand(CLI::App& program, Action& action);
void AddDetectCommand(CLI::App& program, Action& action);
void AddVocabCommand(CLI::App& program, Action& action);
void AddMapCommand(CLI::App& program, Action& action);
void AddBenchCommand(CLI::App& program, Action& action);

/// Exit codes; 130 and 143 after SIGINT and SIGTERM are given by `run` itself.
constexpr int kExitDone = 0, kExitFailure = 1, kExitBadInput = 2;

/// Writes "yorb: MESSAGE" to standard error in one line and gives the error's exit code.
int Complain(const Error& error);

}  // namespace yorb

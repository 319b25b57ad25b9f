// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The program: reads the command line and hands over to the chosen subcommand.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "apps/command.h"

namespace yorb {

int Complain(const Error& error) {
  std::fprintf(stderr, "yorb: %s\n", error.message.c_str());
  return error.kind == Error::Kind::kBadInput ? kExitBadInput : kExitFailure;
}

}  // namespace yorb

int main(int argc, char** argv) {
  CLI::App program{"yorb: visual SLAM that stays accurate among moving people", "yorb"};
  program.require_subcommand(1);
  yorb::Action action;
  yorb::AddRunCommand(program, action);
  yorb::AddCheckCommand(program, action);
  yorb::AddEvalCommand(program, action);
  yorb::AddSynthCommand(program, action);
  yorb::AddBenchCommand(program, action);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? yorb::kExitDone : yorb::kExitBadInput;
  }
  try {
    return action();
  } catch (const std::exception& error) {
    return yorb::Complain(yorb::Failure(std::string("internal failure: ") + error.what()));
  }
}

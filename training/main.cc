// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// yorb-train: reads the command line and hands over to the chosen subcommand.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <opencv2/core.hpp>
#include <string>

#include "core/text.h"
#include "training/command.h"

namespace yorb {
namespace {

constexpr int kExitDone = 0, kExitFailure = 1, kExitBadInput = 2;

int Complain(const Error& error) {
  std::fprintf(stderr, "yorb-train: %s\n", OneLine(error.message).c_str());
  return error.kind == Error::Kind::kBadInput ? kExitBadInput : kExitFailure;
}

int ReadAndAct(int argc, char** argv) {
  CLI::App program{"yorb-train: trains the detectors of yorb on labelled pictures", "yorb-train"};
  program.require_subcommand(1);
  program.footer(
      "Examples:\n"
      "  yorb-train pack pictures/images --out set.pack --split 4:1\n"
      "  yorb-train train set.train.pack --watch set.val.pack --classes classes.txt --out training --epochs 30\n"
      "  yorb-train export training/last.pt detector.onnx\n"
      "  yorb-train train --help");
  Action action;
  AddPackCommand(program, action);
  AddTrainCommand(program, action);
  AddEvaluateCommand(program, action);
  AddExportCommand(program, action);
  AddCurvesCommand(program, action);
  AddTableCommand(program, action);
  AddPeopleMapCommand(program, action);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // help, on standard output
    return Complain(BadInput(std::string(error.what()) + " (yorb-train --help says more)"));
  }
  const Status done = action();
  return done ? kExitDone : Complain(done.error());
}

}  // namespace
}  // namespace yorb

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  try {
    return yorb::ReadAndAct(argc, argv);
  } catch (const std::exception& error) {
    return yorb::Complain(yorb::FailureOf(error));
  }
}

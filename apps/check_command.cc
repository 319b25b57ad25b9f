// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <string>

#include "apps/command.h"
#include "datasets/check.h"

namespace yorb {
namespace {

struct CheckCommandArguments {
  std::string folder;
  std::string camera;
  bool as_json = false;
};

int Check(const CheckCommandArguments& arguments) {
  const SequenceCheck check = CheckSequence(arguments.folder, arguments.camera);
  const std::string text = arguments.as_json ? CheckJson(check) : CheckText(check);
  std::fputs(text.c_str(), stdout);
  if (check.is_usable()) return kExitDone;
  for (const Finding& finding : check.findings) {
    if (finding.level == Finding::Level::kError) return Complain(BadInput(finding.text));
  }
  return kExitBadInput;
}

}  // namespace

void AddCheckCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<CheckCommandArguments>();
  CLI::App* command =
      program.add_subcommand("check", "Say what is right and wrong with a recording, without running SLAM");
  command->add_option("DIR", arguments->folder, "Folder of the recording: rgb.txt and depth.txt, or associations.txt")
      ->required();
  command->add_option("--camera", arguments->camera, "Camera file, or a name such as tum_fr1");
  command->add_flag("--json", arguments->as_json, "Write JSON to standard output, and nothing else");
  command->footer(
      "Examples:\n"
      "  yorb check rgbd_dataset_freiburg1_xyz\n"
      "  yorb check recording --camera camera.yaml --json\n"
      "Exit code 0 when the recording can be used, 2 when not.");
  command->callback([arguments, &action] { action = [arguments] { return Check(*arguments); }; });
}

}  // namespace yorb

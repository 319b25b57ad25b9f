// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>

#include "core/files.h"
#include "training/command.h"
#include "training/curves.h"

namespace yorb {

void AddCurvesCommand(CLI::App& program, Action& action) {
  struct Arguments {
    std::string folder, out;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("curves", "Draw losses, learning rate and scores of a training (SVG)");
  command->add_option("FOLDER", arguments->folder, "The --out folder of the training")->required();
  command->add_option("--out", arguments->out, "The file to write (default: FOLDER/curves.svg)");
  command->callback([arguments, &action] {
    action = [arguments]() -> Status {
      const Result<std::string> svg = CurvesSvg(arguments->folder);
      if (!svg) return svg.error();
      return WriteFileWhole(arguments->out.empty() ? arguments->folder + "/curves.svg" : arguments->out, *svg);
    };
  });
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/files.h"
#include "training/command.h"
#include "training/export_onnx.h"
#include "training/schedule.h"
#include "training/train_state.h"

namespace yorb {
namespace {

struct ExportArguments {
  std::string checkpoint, out, size = "320x256";
  std::vector<std::string> others;
  std::vector<int> stills_px;
  bool takes_last = false;
};

Status Export(const ExportArguments& arguments) {
  const auto phases = ParseSizePhases(arguments.size);
  if (!phases) return phases.error();
  const Result<CheckpointKind> kind = ReadCheckpointKind(arguments.checkpoint);
  if (!kind) return kind.error();
  TrainState state(MakeLayout(kind->layout, kind->table.size()), kind->table, {});
  if (const Status loaded = LoadCheckpoint(arguments.checkpoint, state); !loaded) return loaded;
  if (const Status mixed = AverageWith(arguments.others, state); !mixed) return mixed;
  const std::string bytes = ExportOnnx(arguments.takes_last ? state.network : state.average, kind->table,
                                       phases->back().sizes.front(), arguments.stills_px);
  std::printf("%s: %s after %lld steps, %d classes, %s, %.1f MB\n", arguments.out.c_str(), kind->layout.c_str(),
              static_cast<long long>(state.step), kind->table.size(), arguments.size.c_str(),
              static_cast<double>(bytes.size()) / 1e6);
  return WriteFileWhole(arguments.out, bytes);
}

}  // namespace

void AddExportCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = program.add_subcommand("export", "Write a checkpoint's averaged weights as an ONNX file");
  command->add_option("CHECKPOINT", arguments->checkpoint, "last.pt of a training")->required();
  command->add_option("OUT", arguments->out, "The ONNX file to write")->required();
  command->add_option("--size", arguments->size, "Input size, width x height, multiples of 32")->capture_default_str();
  command->add_option("--with", arguments->others,
                      "Other checkpoints: the mean of all their averaged weights is written");
  command
      ->add_option("--stills", arguments->stills_px,
                   "Longer sides at which `yorb detect` is to look at pictures, a look each")
      ->delimiter(',')
      ->check(CLI::Range(32, 4096));
  command->add_flag("--last", arguments->takes_last, "Export the weights of the last step, not the averaged ones");
  command->callback([arguments, &action] { action = [arguments] { return Export(*arguments); }; });
}

}  // namespace yorb

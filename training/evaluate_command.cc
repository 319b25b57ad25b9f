// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/stopwatch.h"
#include "training/command.h"
#include "training/evaluate.h"
#include "training/open_packs.h"
#include "training/schedule.h"
#include "training/train_state.h"

namespace yorb {
namespace {

struct EvaluateArguments {
  std::string checkpoint, size = "320x256";
  std::vector<std::string> packs;
  int num_threads = 1;
  bool takes_last = false;
};

void Print(const std::string& name, const Evaluation& evaluation, const ClassTable& table) {
  std::printf("%s: mAP50 %.3f, mAP50-95 %.3f\n", name.c_str(), evaluation.map50, evaluation.map);
  for (const ClassScore& score : evaluation.classes)
    std::printf("  %-16s AP50 %.3f  AP %.3f  (%d true boxes)\n",
                table.names[static_cast<size_t>(score.class_index)].c_str(), score.ap50, score.ap, score.num_true);
}

Status EvaluatePacks(const EvaluateArguments& arguments) {
  torch::set_num_threads(arguments.num_threads);
  const auto phases = ParseSizePhases(arguments.size);
  if (!phases) return phases.error();
  const Result<CheckpointKind> kind = ReadCheckpointKind(arguments.checkpoint);
  if (!kind) return kind.error();
  TrainState state(MakeLayout(kind->layout, kind->table.size()), kind->table, {});
  if (const Status loaded = LoadCheckpoint(arguments.checkpoint, state); !loaded) return loaded;
  for (const std::string& path : arguments.packs) {
    const auto pictures = OpenPacks({path}, kind->table);
    if (!pictures) return pictures.error();
    Print(path,
          Evaluate(arguments.takes_last ? state.network : state.average, **pictures, phases->back().sizes.front(),
                   torch::kCPU),
          kind->table);
  }
  return Status::Ok();
}

}  // namespace

void AddEvaluateCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App* command = program.add_subcommand("evaluate", "Measure a checkpoint on packs of pictures");
  command->add_option("CHECKPOINT", arguments->checkpoint, "last.pt of a training")->required();
  command->add_option("PACK", arguments->packs, "Packs to measure on")->required();
  command->add_option("--size", arguments->size, "Input size")->capture_default_str();
  command->add_option("--threads", arguments->num_threads)->check(CLI::Range(1, 256))->capture_default_str();
  command->add_flag("--last", arguments->takes_last, "Measure the weights of the last step, not the averaged ones");
  command->callback([arguments, &action] { action = [arguments] { return EvaluatePacks(*arguments); }; });
}

}  // namespace yorb

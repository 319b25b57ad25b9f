// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "apps/bench_detector.h"
#include "apps/bench_dynamic.h"
#include "apps/bench_features.h"
#include "apps/bench_light.h"
#include "apps/command.h"
#include "apps/sequence_arguments.h"
#include "apps/signals.h"
#include "experiments/speed.h"

namespace yorb {
namespace {

struct SpeedArguments {
  SequenceArguments sequence;
  bool wants_json = false;
};

int Speed(const SpeedArguments& arguments) {
  CatchSignals();
  const auto sequence = OpenSequence(arguments.sequence);
  if (!sequence) return Complain(sequence.error());
  const auto report = MeasureSpeed(*sequence->dataset, sequence->config, IsStopAsked);
  if (!report) return Complain(report.error());
  std::fputs((arguments.wants_json ? SpeedJson(*report) : SpeedText(*report)).c_str(), stdout);
  return ExitCodeAfterSignal(kExitDone);
}

}  // namespace

void AddBenchCommand(CLI::App& program, Action& action) {
  CLI::App* bench = program.add_subcommand("bench", "Measures what this program claims");
  bench->require_subcommand(1);
  bench->footer("Examples:\n  yorb bench speed rgbd_dataset_freiburg1_xyz\n  yorb bench features my_pictures");
  CLI::App* speed = bench->add_subcommand("speed", "Times of every stage beside OpenCV's ORB on the same pictures");
  const auto arguments = std::make_shared<SpeedArguments>();
  arguments->sequence.AddTo(*speed);
  speed->add_flag("--json", arguments->wants_json, "JSON on standard output");
  speed->footer(
      "Examples:\n"
      "  yorb bench speed rgbd_dataset_freiburg1_xyz\n"
      "  yorb bench speed my_room --camera my_camera.yaml --max-frames 300 --json");
  speed->callback([arguments, &action] { action = [arguments] { return Speed(*arguments); }; });
  AddBenchLight(*bench, action);
  AddBenchFeatures(*bench, action);
  AddBenchDetector(*bench, action);
  AddBenchDynamic(*bench, action);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/signals.h"
#include "runs/map_export.h"
#include "runs/map_to_cloud.h"

namespace yorb {
namespace {

struct InfoArguments {
  std::string file;
  bool wants_json = false;
};

struct ExportArguments {
  std::string file, out;
  DenseRequest dense;
  bool is_quiet = false;
};

int Info(const InfoArguments& arguments) {
  const auto saved = ReadMapFile(arguments.file);
  if (!saved) return Complain(saved.error());
  std::fputs((arguments.wants_json ? MapInfoJson(*saved) : MapInfoText(arguments.file, *saved)).c_str(), stdout);
  return kExitDone;
}

int Export(const ExportArguments& arguments) {
  CatchSignals();
  const auto exported = ExportMap(arguments.file, arguments.out, arguments.dense, IsStopAsked);
  if (!exported) return Complain(exported.error());
  if (exported->was_stopped) return ExitCodeAfterSignal(kExitDone);
  if (arguments.is_quiet) return kExitDone;
  for (const std::string& line : exported->lines) std::printf("%s\n", line.c_str());
  return kExitDone;
}

void AddMapInfo(CLI::App& map, Action& action) {
  CLI::App* info = map.add_subcommand("info", "Says what is in a map file, which is read and checked whole");
  const auto arguments = std::make_shared<InfoArguments>();
  info->add_option("FILE", arguments->file, "A file of `yorb run --save-map`")->required();
  info->add_flag("--json", arguments->wants_json, "JSON on standard output");
  info->footer("Examples:\n  yorb map info office.map\n  yorb map info office.map --json");
  info->callback([arguments, &action] { action = [arguments] { return Info(*arguments); }; });
}

void AddExport(CLI::App& map, Action& action) {
  CLI::App* command = map.add_subcommand("export", "Writes a map's points or keyframes for other programs");
  const auto arguments = std::make_shared<ExportArguments>();
  DenseRequest& dense = arguments->dense;
  command->add_option("FILE", arguments->file, "A file of `yorb run --save-map`")->required();
  command->add_option("--out", arguments->out, "X.ply or X.pcd: the landmarks; X.txt: the keyframes as a TUM list")
      ->required();
  command->add_option("--dense", dense.sequence,
                      "The sequence that the map was made of: its depth pictures at the keyframes become a coloured "
                      "cloud, in place of the landmarks");
  std::vector<CLI::Option*> dense_only;
  const auto add = [&](const char* name, auto& value, const char* help) {
    dense_only.push_back(command->add_option(name, value, help));
  };
  add("--cube", dense.cube_m, "Of all points in a cube of this side one stays, metres");
  add("--dynamics", dense.config.dynamics,
      "full (the default): moving people are left out of the cloud; off: nothing is");
  add("--detections", dense.config.detections, "A file with boxes in the detector's place");
  add("--masks", dense.config.masks, "PNGs, or one for all: what is not 0 is left out");
  add("--model", dense.config.detection.model, "The detector's network, any YOLO export in ONNX");
  command->add_flag("--quiet", arguments->is_quiet, "Nothing on standard output");
  command->footer(
      "Examples:\n"
      "  yorb map export office.map --out office.ply\n"
      "  yorb map export office.map --out office_keyframes.txt\n"
      "  yorb map export office.map --out office_dense.ply --dense recordings/office\n"
      "Sub-maps that were never joined have worlds of their own: X.ply is that of the run's trajectory.txt, then "
      "X_2.ply\n"
      "and so on. A line a file says what it has, from when to when.");
  command->callback([arguments, dense_only, &action] {
    for (const CLI::Option* option : dense_only) {
      if (option->count() > 0) arguments->dense.named_option = option->get_name();
    }
    action = [arguments] { return Export(*arguments); };
  });
}

}  // namespace

void AddMapCommand(CLI::App& program, Action& action) {
  CLI::App* map = program.add_subcommand("map", "Looks into the maps of `yorb run --save-map`, and exports them");
  map->require_subcommand(1);
  map->footer("Examples:\n  yorb map info office.map\n  yorb map export office.map --out office.ply");
  AddMapInfo(*map, action);
  AddExport(*map, action);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/command.h"
#include "core/files.h"
#include "core/text.h"
#include "datasets/open_dataset.h"
#include "datasets/tum.h"
#include "evaluation/chart_png.h"
#include "evaluation/evaluate.h"
#include "evaluation/evaluation_text.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr double kPngZoom = 1.5;

/// The options as they were written; numbers stay text until they are read without a locale.
struct EvalArguments {
  std::string reference;
  std::vector<std::string> estimates;
  std::optional<std::string> sequence, frames, rpe_unit, csv, plot, reference_format;
  std::string align = "se3", format = "auto", rpe_delta = "1", max_difference = "0.02", time_offset = "0";
  bool is_json = false;
};

Result<double> Number(const std::string& option, const std::string& text) {
  const auto value = ParseDouble(Trim(text));
  if (!value || !std::isfinite(*value)) return BadInput(option + " " + text + " is not a finite number");
  return *value;
}

TrajectoryFormat FormatOf(const std::string& word) {
  if (word == "tum") return TrajectoryFormat::kTum;
  if (word == "kitti") return TrajectoryFormat::kKitti;
  return word == "euroc" ? TrajectoryFormat::kEuroc : TrajectoryFormat::kAuto;
}

EvalAlign AlignOf(const std::string& word) {
  if (word == "none") return EvalAlign::kNone;
  return word == "sim3" ? EvalAlign::kSim3 : EvalAlign::kSe3;
}

/// Rows without stamps have no seconds: they are counted unless something else is asked for.
Result<RpeUnit> UnitOf(const std::optional<std::string>& word, const ReadTrajectory& reference) {
  if (!word) return reference.has_stamps ? RpeUnit::kSeconds : RpeUnit::kFrames;
  if (*word == "s" && !reference.has_stamps)
    return BadInput(reference.path + " has no time stamps; use --rpe-unit frames or m");
  if (*word == "s") return RpeUnit::kSeconds;
  return *word == "m" ? RpeUnit::kMetres : RpeUnit::kFrames;
}

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Of the colour pictures that a run would read; the pictures themselves need not be there.
Result<std::vector<Timestamp>> ReadPictureStamps(const std::string& folder) {
  if (const Status there = CheckLayout(folder); !there) return BadInput("--sequence: " + there.error().message);
  const auto list = ReadColourList(folder);
  if (!list) return list.error();
  return list->Times();
}

Result<EvalOptions> ReadOptions(const EvalArguments& arguments, const ReadTrajectory& reference) {
  EvalOptions options;
  options.align = AlignOf(arguments.align);
  const auto delta = Number("--rpe-delta", arguments.rpe_delta),
             difference = Number("--max-difference", arguments.max_difference),
             offset = Number("--time-offset", arguments.time_offset);
  for (const auto* number : {&delta, &difference, &offset}) {
    if (!*number) return number->error();
  }
  options.rpe_delta = *delta;
  options.max_difference = *difference;
  options.time_offset = *offset;
  const auto unit = UnitOf(arguments.rpe_unit, reference);
  if (!unit) return unit.error();
  options.rpe_unit = *unit;
  if (arguments.frames) {
    const auto count = ParseInteger(Trim(*arguments.frames));
    if (!count || *count < 1) return BadInput("--frames " + *arguments.frames + " must be a whole number, 1 or more");
    options.num_frames = static_cast<size_t>(*count);
  }
  if (arguments.sequence) {
    const auto pictures = ReadPictureStamps(*arguments.sequence);
    if (!pictures) return pictures.error();
    options.pictures = *pictures;
  }
  if (const Status status = Validate(options); !status) return status.error();
  return options;
}

/// What is read, as it is called in a complaint, and where it stands.
std::vector<std::pair<std::string, fs::path>> InputsOf(const EvalArguments& arguments) {
  std::vector<std::pair<std::string, fs::path>> inputs = {{"--reference", arguments.reference}};
  for (const std::string& estimate : arguments.estimates) inputs.emplace_back("--estimate", estimate);
  if (arguments.sequence) {
    for (const std::string& list : ListNames()) inputs.emplace_back("--sequence", fs::path(*arguments.sequence) / list);
  }
  return inputs;
}

/// What is written must not take the place of what is read.
Status CheckInputsKept(const char* option, const std::optional<std::string>& path, const EvalArguments& arguments) {
  std::error_code ignored;
  if (!path || !fs::is_regular_file(*path, ignored)) return Status::Ok();
  for (const auto& [name, input] : InputsOf(arguments)) {
    if (fs::equivalent(*path, input, ignored))
      return BadInput(std::string(option) + " " + *path + " would overwrite what " + name +
                      " reads; name another file");
  }
  return Status::Ok();
}

/// Whether two paths lead to one place, be something there or not.
bool IsSamePlace(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(a, ignored), ignored) ==
         fs::weakly_canonical(fs::absolute(b, ignored), ignored);
}

Status CheckOutputs(const EvalArguments& arguments) {
  if (arguments.plot && !EndsWith(*arguments.plot, ".svg") && !EndsWith(*arguments.plot, ".png")) {
    return BadInput("--plot " + *arguments.plot + " must end in .svg or .png");
  }
  if (arguments.csv && arguments.plot && IsSamePlace(*arguments.csv, *arguments.plot)) {
    return BadInput("--csv " + *arguments.csv + " and --plot would be one file; name another one");
  }
  if (const Status fine = CheckInputsKept("--csv", arguments.csv, arguments); !fine) return fine;
  return CheckInputsKept("--plot", arguments.plot, arguments);
}

Status WritePlot(const std::string& path, const std::string& svg) {
  if (EndsWith(path, ".svg")) return WriteFileWhole(path, svg);
  const auto png = PngFromSvg(svg, kPngZoom);
  return png ? WriteFileWhole(path, *png) : Status(png.error());
}

void Warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) std::fprintf(stderr, "yorb: warning: %s\n", warning.c_str());
}

Status EvaluateAll(const EvalArguments& arguments) {
  if (const Status fine = CheckOutputs(arguments); !fine) return fine;
  const auto reference =
      ReadTrajectoryFile(arguments.reference, FormatOf(arguments.reference_format.value_or(arguments.format)));
  if (!reference) return reference.error();
  const auto options = ReadOptions(arguments, *reference);
  if (!options) return options.error();
  std::vector<Evaluation> evaluations;
  for (const std::string& path : arguments.estimates) {
    const auto estimate = ReadTrajectoryFile(path, FormatOf(arguments.format));
    if (!estimate) return estimate.error();
    auto evaluation = Evaluate(*reference, *estimate, *options);
    if (!evaluation) return evaluation.error();
    evaluations.push_back(std::move(*evaluation));
  }
  Warn(reference->warnings);
  for (const Evaluation& evaluation : evaluations) Warn(evaluation.warnings);
  if (arguments.csv) {
    if (Status status = WriteFileWhole(*arguments.csv, EvaluationCsv(evaluations, reference->poses)); !status)
      return status;
  }
  if (arguments.plot) {
    if (Status status = WritePlot(*arguments.plot, EvaluationSvg(evaluations, reference->poses)); !status)
      return status;
  }
  const std::string text =
      arguments.is_json ? EvaluationJson(evaluations, *options) : EvaluationText(evaluations, *options);
  std::fputs(text.c_str(), stdout);
  return Status::Ok();
}

void AddOptions(CLI::App& command, EvalArguments& arguments) {
  const CLI::IsMember formats({"auto", "tum", "kitti", "euroc"});
  command.add_option("--reference", arguments.reference, "The true trajectory")->required();
  command
      .add_option("--estimate", arguments.estimates,
                  "The estimated trajectory; several give a table with mean and s.d.")
      ->required();
  CLI::Option* sequence = command.add_option(
      "--sequence", arguments.sequence, "Folder of the sequence in TUM layout: its colour pictures count for coverage");
  command.add_option("--frames", arguments.frames, "Number of the sequence's pictures, for coverage")
      ->excludes(sequence);
  command.add_option("--align", arguments.align, "How the estimate is brought to the reference (se3)")
      ->check(CLI::IsMember({"se3", "sim3", "none"}));
  command.add_option("--rpe-delta", arguments.rpe_delta, "Distance of the two poses of a relative error (1)");
  command
      .add_option("--rpe-unit", arguments.rpe_unit,
                  "Unit of --rpe-delta: seconds, metres along the estimate's path, rows (s)")
      ->check(CLI::IsMember({"s", "m", "frames"}));
  command.add_option("--max-difference", arguments.max_difference,
                     "Seconds below which two stamps belong together (0.02)");
  command.add_option("--time-offset", arguments.time_offset, "Seconds added to the estimate's stamps (0)");
  command.add_option("--format", arguments.format, "Format of the files: auto is TUM's, or what a header says")
      ->check(formats);
  command
      .add_option("--reference-format", arguments.reference_format, "Format of the reference, where it is another one")
      ->check(formats);
  command.add_flag("--json", arguments.is_json, "One JSON document on standard output");
  command.add_option("--csv", arguments.csv, "Writes the error of every pair to this file");
  command.add_option("--plot", arguments.plot, "Draws path, coordinates and errors into this .svg or .png file");
}

}  // namespace

void AddEvalCommand(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("eval", "Measures an estimated trajectory against the true one: ATE, RPE, coverage");
  const auto arguments = std::make_shared<EvalArguments>();
  AddOptions(*command, *arguments);
  command->footer(
      "Examples:\n"
      "  yorb eval --reference groundtruth.txt --estimate results/trajectory.txt --sequence "
      "rgbd_dataset_freiburg1_xyz\n"
      "  yorb eval --reference groundtruth.txt --estimate run1.txt run2.txt run3.txt --plot runs.svg\n"
      "  yorb eval --reference groundtruth.txt --estimate mono.txt --align sim3 --rpe-delta 0.5 --rpe-unit m --json\n"
      "  yorb eval --reference mav0/state_groundtruth_estimate0/data.csv --reference-format euroc --estimate "
      "trajectory.txt");
  command->callback([arguments, &action] {
    action = [arguments] {
      const Status status = EvaluateAll(*arguments);
      return status ? kExitDone : Complain(status.error());
    };
  });
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/progress.h"
#include "apps/sequence_arguments.h"
#include "apps/signals.h"
#include "camera/builtin_cameras.h"
#include "camera/camera_io.h"
#include "core/parallel.h"
#include "core/stopwatch.h"
#include "core/text.h"
#include "synthetic/write_sequence.h"

namespace yorb {
namespace {

constexpr int kDefaultFrames = 300, kDefaultLoopFrames = 600;

/// The options as they were written: numbers are read by us, so that complaints are ours and the locale does not count.
struct SynthArguments {
  std::string path, out;
  std::optional<std::string> frames, seed, people, noise, width, height, distortion, camera, quality, threads;
  bool is_png = false, is_quiet = false;
};

/// The camera to render with: --camera or fr3's, at the size asked for, with the distortion asked for.
Result<Rig> RigOf(const SynthArguments& arguments) {
  Rig rig = SyntheticRig();
  if (arguments.camera) {
    auto read = ReadCamera(*arguments.camera);
    if (!read) return read.error();
    rig = *std::move(read);
  }
  const auto width = WholeNumber("--width", arguments.width, rig.camera.width, 64, 4096);
  if (!width) return width.error();
  const auto height = WholeNumber("--height", arguments.height, rig.camera.height, 64, 4096);
  if (!height) return height.error();
  if (*width == 0 || *height == 0)
    return BadInput("camera " + rig.name + " states no picture size; give --width and --height");
  if (arguments.camera) {
    auto fitted = FitToPictures(rig, static_cast<int>(*width), static_cast<int>(*height));
    if (!fitted) return fitted.error();
    rig = fitted->rig;
  } else {
    rig = SyntheticRig(static_cast<int>(*width), static_cast<int>(*height));
  }
  if (!arguments.distortion) return rig;
  const auto fields = SplitAt(*arguments.distortion, ',');
  if (fields.size() != 4 && fields.size() != 5 && fields.size() != 8)
    return BadInput("--distortion takes 4, 5 or 8 numbers with commas between them: k1,k2,p1,p2[,k3[,k4,k5,k6]]");
  rig.camera.distortion = {};  // a list that is shorter than the camera's leaves none of its numbers behind
  for (size_t i = 0; i < fields.size(); ++i) {
    const auto number = ParseDouble(fields[i]);
    if (!number || !std::isfinite(*number))
      return BadInput("--distortion: " + std::string(fields[i]) + " is no number");
    rig.camera.distortion[i] = *number;
  }
  return rig;
}

Result<SequenceOptions> SequenceOf(const SynthArguments& arguments) {
  SequenceOptions options;
  const auto path = ParsePathKind(arguments.path);
  if (!path)
    return BadInput(arguments.path + " is no camera path; did you mean " + NearestWord(arguments.path, PathNames()) +
                    "?");
  options.path = *path;
  const auto frames = WholeNumber("--frames", arguments.frames,
                                  *path == PathKind::kLoop ? kDefaultLoopFrames : kDefaultFrames, 1, 1000000);
  if (!frames) return frames.error();
  options.num_frames = static_cast<int>(*frames);
  const auto seed = WholeNumber("--seed", arguments.seed, 1, 0, std::numeric_limits<long long>::max());
  if (!seed) return seed.error();
  options.seed = static_cast<uint64_t>(*seed);
  const auto people = WholeNumber("--people", arguments.people, 0, 0, kMaxPeople);
  if (!people) return people.error();
  options.num_people = static_cast<int>(*people);
  const auto noise = ParseDouble(arguments.noise.value_or("1"));
  if (!noise) return BadInput("--noise must be a number from 0 (none) to 20, not " + *arguments.noise);
  options.noise = *noise;
  auto rig = RigOf(arguments);
  if (!rig) return rig.error();
  options.rig = *std::move(rig);
  const auto threads = WholeNumber("--threads", arguments.threads, NumHardwareThreads(), 1, 1024);
  if (!threads) return threads.error();
  options.room.num_threads = static_cast<int>(*threads);
  const Status checked = CheckOptions(options);
  if (!checked) return checked.error();
  return options;
}

/// The command that renders the same again.
std::string Describe(const SynthArguments& arguments, const SequenceOptions& options) {
  std::string text = "yorb synth " + arguments.path + " --frames " + std::to_string(options.num_frames) + " --seed " +
                     std::to_string(options.seed) + " --people " + std::to_string(options.num_people) + " --noise " +
                     FormatShortest(options.noise) + " --width " + std::to_string(options.rig.camera.width) +
                     " --height " + std::to_string(options.rig.camera.height);
  if (arguments.camera) text += " --camera " + *arguments.camera;
  if (arguments.distortion) text += " --distortion " + *arguments.distortion;
  if (arguments.is_png) text += " --png";
  if (arguments.quality) text += " --quality " + *arguments.quality;
  return text;
}

int Synth(const SynthArguments& arguments) {
  const Stopwatch watch;
  const auto options = SequenceOf(arguments);
  if (!options) return Complain(options.error());
  const auto quality = WholeNumber("--quality", arguments.quality, 95, 1, 100);
  if (!quality) return Complain(quality.error());
  const Status prepared = PrepareFolder(arguments.out, Describe(arguments, *options));
  if (!prepared) return Complain(prepared.error());

  CatchSignals();
  Progress progress(arguments.is_quiet);
  WriteHooks hooks;
  hooks.should_stop = IsStopAsked;
  hooks.on_progress = [&](size_t num_done, size_t num_frames) { progress.Show(num_done, num_frames); };
  const WriteOptions write{arguments.out, arguments.is_png, static_cast<int>(*quality), options->room.num_threads};
  const auto num_written = WriteSequence(SyntheticSequence(*options), write, hooks);
  progress.End();
  if (!num_written) return Complain(num_written.error());
  if (!arguments.is_quiet) {
    std::printf("%zu frames of %dx%d rendered into %s in %s s\n", *num_written, options->rig.camera.width,
                options->rig.camera.height, arguments.out.c_str(), FormatFixed(watch.seconds(), 1).c_str());
  }
  return ExitCodeAfterSignal(kExitDone);
}

}  // namespace

void AddSynthCommand(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("synth", "Renders an RGB-D sequence of a furnished room, with exact truth, in TUM layout");
  const auto a = std::make_shared<SynthArguments>();
  command->add_option("path", a->path, "How the camera moves: xyz, halfsphere, rpy, static or loop")
      ->required()
      ->type_name("PATH");
  command->add_option("--out", a->out, "The folder to render into; an earlier rendering in it is replaced")
      ->required()
      ->type_name("DIR");
  command->add_option("--frames", a->frames, "How many, at 30 a second [300; loop: 600]")->type_name("N");
  command->add_option("--seed", a->seed, "Another room, other people, another hand [1]")->type_name("N");
  command->add_option("--people", a->people, "How many walk through the room [0]; people.txt and mask/ say where")
      ->type_name("N");
  command->add_option("--noise", a->noise, "Of colour and depth: 0 exact, 1 like a Kinect [1]")->type_name("X");
  command->add_option("--width", a->width, "Of the pictures [640]")->type_name("PX");
  command->add_option("--height", a->height, "Of the pictures [480]")->type_name("PX");
  command->add_option("--camera", a->camera, "Another camera than TUM freiburg3's: a known name or a camera file")
      ->type_name("NAME|FILE");
  command->add_option("--distortion", a->distortion, "The lens: k1,k2,p1,p2[,k3[,k4,k5,k6]] as OpenCV has them")
      ->type_name("LIST");
  command->add_flag("--png", a->is_png, "Colour as PNG, without loss, instead of JPEG");
  command->add_option("--quality", a->quality, "Of the JPEGs, 1 to 100 [95]")->type_name("N");
  command->add_option("--threads", a->threads, "At most so many; the result is the same [all cores]")->type_name("N");
  command->add_flag("--quiet", a->is_quiet, "Nothing on standard output");
  command->footer(
      "Writes rgb/ depth/ mask/ rgb.txt depth.txt groundtruth.txt people.txt camera.yaml; `yorb run DIR` reads it as "
      "it is.\n"
      "Examples:\n"
      "  yorb synth halfsphere --out demo --people 2\n"
      "  yorb synth loop --out round --frames 600 --seed 7\n"
      "  yorb synth xyz --out exact --frames 60 --noise 0 --png --width 320 --height 240");
  command->callback([a, &action] { action = [a] { return Synth(*a); }; });
}

}  // namespace yorb

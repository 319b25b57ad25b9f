// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/files.h"
#include "core/stopwatch.h"
#include "training/command.h"
#include "training/people_check.h"
#include "training/people_compose.h"
#include "training/people_trainer.h"
#include "training/split.h"
#include "training/stop_signal.h"

namespace yorb {
namespace {

struct PeopleMapArguments {
  std::vector<std::string> masked, scenes;
  std::string cutouts, network, out;
  int64_t num_pictures = 14000;
  int num_loaders = 1, num_threads = 1, held_percent = 5;
  PeopleTrainerOptions trainer;
};

/// A network that stays as it is.
struct FrozenNetwork {
  std::string path;
  OnnxModel model;
  FeatureTaps taps;
};

/// All there is to learn from, and to measure on.
struct PeopleMaterial {
  Split masked;
  PlainScenes scenes;
  std::vector<cv::Mat> cutouts;
};

Result<FrozenNetwork> ReadFrozen(const std::string& path) {
  Result<OnnxModel> read = ReadOnnxFile(path);
  if (!read) return read.error();
  OnnxModel model = WithoutPeopleHead(*std::move(read));
  const Result<FeatureTaps> taps = FindFeatureTaps(model, path);
  if (!taps) return taps.error();
  return FrozenNetwork{path, std::move(model), *taps};
}

Result<Split> FindMasked(const PeopleMapArguments& arguments) {
  std::vector<LabelledFile> files;
  for (const std::string& folder : arguments.masked) {
    const auto found = FindMaskedFiles(folder);
    if (!found) return found.error();
    files.insert(files.end(), found->begin(), found->end());
  }
  const SplitRatio ratio{100 - arguments.held_percent, arguments.held_percent};
  Split split = SplitFiles(files, ratio, arguments.trainer.seed);
  if (split.train.empty()) return BadInput(arguments.masked[0] + ": too few pictures with masks to learn from");
  return split;
}

Result<PeopleMaterial> FindMaterial(const PeopleMapArguments& arguments) {
  const Result<Split> masked = FindMasked(arguments);
  if (!masked) return masked.error();
  const Result<PlainScenes> scenes = FindPlainScenes(arguments.scenes);
  if (!scenes) return scenes.error();
  Result<std::vector<cv::Mat>> cutouts = CutOutPeople(masked->train);
  if (!cutouts) return cutouts.error();
  if (!arguments.cutouts.empty()) {
    const auto more = ReadCutouts(arguments.cutouts);
    if (!more) return more.error();
    cutouts->insert(cutouts->end(), more->begin(), more->end());
  }
  std::printf(
      "%zu pictures with masks to learn from and %zu to measure on, %zu empty scenes, %zu with people, %zu cut-outs\n",
      masked->train.size(), masked->val.size(), scenes->empty.size(), scenes->peopled.size(), cutouts->size());
  std::fflush(stdout);
  return PeopleMaterial{*masked, *scenes, std::move(*cutouts)};
}

int MinutesLeft(double seconds, int64_t done, int64_t all) {
  return static_cast<int>(std::lround(seconds / static_cast<double>(done) * static_cast<double>(all - done) / 60));
}

Result<FeatureSet> MakeAll(const SceneSource& source, const FrozenNetwork& network, int num_threads,
                           const std::string& what) {
  std::vector<FeatureMaker> makers;
  for (int i = 0; i < num_threads; ++i) {
    Result<FeatureMaker> maker = FeatureMaker::Make(network.model, network.taps, network.path);
    if (!maker) return maker.error();
    makers.push_back(std::move(*maker));
  }
  const Stopwatch watch;
  int64_t shown = 0;
  const auto show = [&](int64_t done) {
    if (IsStopAsked()) return false;
    if (done < shown + 500 && done < source.count) return true;
    shown = done;
    std::printf("%s: %lld of %lld  %.1f pictures/s  %d min left\n", what.c_str(), static_cast<long long>(done),
                static_cast<long long>(source.count), static_cast<double>(done) / watch.seconds(),
                MinutesLeft(watch.seconds(), done, source.count));
    std::fflush(stdout);
    return true;
  };
  return MakeFeatures(source, std::move(makers), show);
}

Result<FeatureSet> MakeHeld(const std::vector<LabelledFile>& files, const FrozenNetwork& network, int num_threads) {
  if (files.empty()) return FeatureSet{{}, {}, torch::empty({0, 1, 1})};
  const auto make = [&](int64_t i) -> Result<Scene> {
    const Result<MaskedPicture> picture = ReadMaskedPicture(files[static_cast<size_t>(i)]);
    if (!picture) return picture.error();
    return LetterboxMasked(*picture, network.taps.input);
  };
  return MakeAll({static_cast<int64_t>(files.size()), make}, network, num_threads, "pictures to measure on");
}

Status TrainOn(const FeatureSet& set, const FeatureSet& held, const PeopleTrainerOptions& options, PeopleHead head) {
  const Stopwatch watch;
  const auto show = [&](const PeopleReport& report) {
    std::printf("epoch %d of %d  step %lld of %lld  loss %.4f  %d min left\n", report.epoch, options.epochs,
                static_cast<long long>(report.step), static_cast<long long>(report.num_steps), report.loss,
                MinutesLeft(watch.seconds(), report.step, report.num_steps));
    if (report.is_end_of_epoch && held.size() > 0) {
      const CellScores scores = MeasureCells(head, held);
      std::printf("epoch %d: IoU %.3f  precision %.3f  recall %.3f of the cells of %lld held pictures\n", report.epoch,
                  scores.iou, scores.precision, scores.recall, static_cast<long long>(held.size()));
    }
    std::fflush(stdout);
  };
  return TrainPeopleHead(head, set, options, show, IsStopAsked);
}

Status WriteAndCheck(const FrozenNetwork& network, const PeopleHead& head, const cv::Mat& picture,
                     const std::string& out) {
  const Result<OnnxModel> made = WithPeopleHead(network.model, network.taps, head, network.path);
  if (!made) return made.error();
  if (const Status written = WriteFileWhole(out, OnnxBytes(*made)); !written) return written;
  const Result<OnnxModel> read = ReadOnnxFile(out);
  if (!read) return read.error();
  const Result<double> difference = CheckPeopleOutput({network.model, *read}, network.taps, head, picture);
  if (!difference) return Failure(out + ": " + difference.error().message);
  std::printf("%s: its map of people is libtorch's to %.1e, its %zu other outputs are what they were\n", out.c_str(),
              *difference, network.model.outputs.size());
  return Status::Ok();
}

Status TrainPeopleMap(const PeopleMapArguments& arguments) {
  CatchStopSignals();
  torch::set_num_threads(arguments.num_threads);
  torch::manual_seed(arguments.trainer.seed);
  const Result<FrozenNetwork> network = ReadFrozen(arguments.network);
  if (!network) return network.error();
  const Result<PeopleMaterial> material = FindMaterial(arguments);
  if (!material) return material.error();
  const PeopleComposer composer(material->masked.train, material->scenes, material->cutouts, {});
  const auto compose = [&](int64_t i) {
    Random random(arguments.trainer.seed, static_cast<uint64_t>(i));
    return composer.Compose(network->taps.input, random);
  };
  const auto held = MakeHeld(material->masked.val, *network, arguments.num_loaders);
  if (!held) return held.error();
  const auto set =
      MakeAll({arguments.num_pictures, compose}, *network, arguments.num_loaders, "pictures to learn from");
  if (!set) return set.error();
  PeopleHead head(network->taps.fine_channels, network->taps.coarse_channels);
  if (const Status trained = TrainOn(*set, *held, arguments.trainer, head); !trained) return trained;
  const Result<Scene> scene = compose(0);
  if (!scene) return scene.error();
  return WriteAndCheck(*network, head, scene->pixels, arguments.out);
}

}  // namespace

void AddPeopleMapCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<PeopleMapArguments>();
  CLI::App& command = *program.add_subcommand(
      "people-map", "Teach a detector that stays as it is to say which cells of a picture show people");
  command
      .add_option("--masked", arguments->masked,
                  "Folders with images/NAME.jpg and masks/NAME.png: 255 person, 0 nobody, 128 unknown")
      ->required();
  command.add_option("--scenes", arguments->scenes,
                     "Packs, or folders of labelled pictures, that are labelled for people by boxes");
  command.add_option("--cutouts", arguments->cutouts, "Folder of cut-outs of people (RGBA) to be pasted, too");
  command
      .add_option("--network", arguments->network,
                  "The detector: an ONNX file of yorb-train export; a map of people that it has is replaced")
      ->required();
  command.add_option("--out", arguments->out, "The ONNX file to write: the detector with one more output")->required();
  command.add_option("--pictures", arguments->num_pictures, "Composed to learn from, half a megabyte of memory each")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command.add_option("--held", arguments->held_percent, "Percent of the pictures with masks to measure on")
      ->check(CLI::Range(0, 90))
      ->capture_default_str();
  command.add_option("--epochs", arguments->trainer.epochs, "How often each picture is learnt from")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command.add_option("--batch", arguments->trainer.batch_size)->check(CLI::Range(1, 4096))->capture_default_str();
  command.add_option("--rate", arguments->trainer.rate, "Highest learning rate (AdamW)")->capture_default_str();
  command.add_option("--seed", arguments->trainer.seed, "Of all chance")->capture_default_str();
  command.add_option("--loaders", arguments->num_loaders, "Threads that compose pictures and run the detector on them")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command.add_option("--threads", arguments->num_threads, "Threads of the training")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command.callback([arguments, &action] { action = [arguments] { return TrainPeopleMap(*arguments); }; });
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/text.h"
#include "training/assign.h"
#include "training/command.h"
#include "training/open_packs.h"
#include "training/stop_signal.h"
#include "training/trainer.h"
#include "training/unfold.h"

namespace yorb {
namespace {

struct TrainArguments {
  std::string network = "yolo-mo", classes, backbone, weights, teacher, people, out, sizes = "320x256", device = "cpu";
  std::vector<std::string> packs, watched;
  double epochs = 0, minutes = 0;
  int num_threads = 1;
  bool should_resume = false;
  LoaderOptions loader;
  OptimizerOptions optimizer;
  TrainerOptions trainer;
};

Result<torch::Device> ReadDevice(const std::string& name) {
  const std::string wrong = "--device " + OneLine(name) + ": ";
  try {
    const torch::Device device(name);
    if (!device.is_cpu() && !device.is_cuda()) return BadInput(wrong + "only cpu and cuda are known");
    if (device.is_cuda() && !torch::cuda::is_available())
      return BadInput(wrong + "this libtorch sees no such device; --device cpu works everywhere");
    return device;
  } catch (const c10::Error&) {
    return BadInput(wrong + "is none such as cpu, cuda or cuda:1");
  }
}

Result<TrainerOptions> MakeTrainerOptions(const TrainArguments& arguments, size_t num_pictures) {
  const auto phases = ParseSizePhases(arguments.sizes);
  if (!phases) return phases.error();
  if ((arguments.epochs > 0) == (arguments.minutes > 0))
    return BadInput("either --epochs or --minutes says how long the training is");
  const Result<torch::Device> device = ReadDevice(arguments.device);
  if (!device) return device.error();
  TrainerOptions options = arguments.trainer;
  options.schedule.phases = *phases;
  options.schedule.minutes = arguments.minutes;
  options.schedule.num_steps = static_cast<int64_t>(
      std::ceil(arguments.epochs * static_cast<double>(num_pictures) / arguments.loader.batch_size));
  options.out = arguments.out;
  options.device = *device;
  return options;
}

/// As from a checkpoint, from a file in which the norms are folded.
Status BeginFromOnnx(const TrainArguments& arguments, const Composer& pictures, const cv::Size& size,
                     const torch::Device& device, TrainState& state) {
  std::vector<Scene> scenes;
  const size_t step = std::max<size_t>(1, pictures.size() / 64);
  for (size_t i = 0; i < pictures.size(); i += step) scenes.push_back(pictures.Letterbox(i, size));
  const torch::Tensor input = ToInput(MakeBatch(scenes, state.table.size()).pictures, device);
  if (const Status read = ReadFoldedWeights(arguments.weights, state.table, input, state.network); !read) return read;
  return ReadFoldedWeights(arguments.weights, state.table, input, state.average);
}

/// The state to begin from: the last checkpoint, other weights, or the ImageNet backbone and chance.
Status Begin(const TrainArguments& arguments, const Composer& pictures, const TrainerOptions& options,
             TrainState& state) {
  const std::string checkpoint = arguments.out + "/last.pt";
  if (std::filesystem::exists(checkpoint)) {
    if (!arguments.should_resume)
      return BadInput(checkpoint + ": is there already; --resume goes on with it, another --out begins anew");
    return LoadCheckpoint(checkpoint, state);
  }
  if (arguments.weights.ends_with(".onnx"))
    return BeginFromOnnx(arguments, pictures, options.schedule.phases.back().sizes.front(), options.device, state);
  if (!arguments.weights.empty()) return BeginFrom(arguments.weights, state);
  if (arguments.backbone.empty()) return Status::Ok();
  if (const Status loaded = LoadBackbone(arguments.backbone, state.network); !loaded) return loaded;
  return LoadBackbone(arguments.backbone, state.average);
}

void ShowProgress(const TrainReport& report) {
  const double left_s = report.progress > 0 ? report.seconds / report.progress * (1 - report.progress) : 0;
  std::printf(
      "%5.1f %%  step %lld  %dx%d  %.1f pictures/s  box %.4f  objectness %.4f  classes %.4f  teacher %.4f  %d min "
      "left\n",
      100 * report.progress, static_cast<long long>(report.step), report.size.width, report.size.height,
      report.pictures_per_second, report.box, report.objectness, report.classes, report.teacher,
      static_cast<int>(std::lround(left_s / 60)));
  std::fflush(stdout);
}

/// How many of the true boxes the anchors fit; few would mean that other anchors are needed.
void ShowAnchors(const Composer& pictures, const Layout& layout, const cv::Size& size) {
  std::vector<Scene> scenes;
  const size_t step = std::max<size_t>(1, pictures.size() / 200);
  for (size_t i = 0; i < pictures.size(); i += step) scenes.push_back(pictures.Letterbox(i, size));
  const Batch batch = MakeBatch(scenes, layout.num_classes);
  std::printf("anchors fit %.1f %% of %zu boxes in %zu pictures\n", 100 * AnchorRecall(batch.targets, layout),
              batch.targets.size(), scenes.size());
}

Result<std::vector<WatchedSet>> OpenWatched(const std::vector<std::string>& paths, const ClassTable& table) {
  std::vector<WatchedSet> watched;
  for (const std::string& path : paths) {
    const auto set = OpenPacks({path}, table);
    if (!set) return set.error();
    watched.push_back({std::filesystem::path(path).stem().string(), *set});
  }
  return watched;
}

Status TakeTeacher(const std::string& path, const ClassTable& table, TrainerOptions& options) {
  if (path.empty()) return Status::Ok();
  Result<Teacher> teacher = ReadTeacher(path, table);
  if (!teacher) return teacher.error();
  teacher->network->to(options.device);
  options.teacher = *teacher;
  return Status::Ok();
}

Result<Loader> MakeLoader(const TrainArguments& arguments, std::shared_ptr<const Composer> pictures,
                          const ClassTable& table, const TrainerOptions& trainer, const Schedule& schedule) {
  std::vector<cv::Mat> cutouts;
  if (!arguments.people.empty()) {
    const auto read = ReadCutouts(arguments.people);
    if (!read) return read.error();
    cutouts = *read;
  }
  LoaderOptions options = arguments.loader;
  options.is_pinned = trainer.device.is_cuda();
  return Loader(std::move(pictures), cutouts, table, options,
                [schedule](int64_t step) { return schedule.SizeAt(step); });
}

Status Train(const TrainArguments& arguments) {
  torch::set_num_threads(arguments.num_threads);
  torch::manual_seed(arguments.loader.seed);
  const Result<ClassTable> table = ReadClassTable(arguments.classes);
  if (!table) return table.error();
  const auto pictures = OpenPacks(arguments.packs, *table);
  if (!pictures) return pictures.error();
  Result<TrainerOptions> options = MakeTrainerOptions(arguments, (*pictures)->size());
  if (!options) return options.error();
  if (const Status taken = TakeTeacher(arguments.teacher, *table, *options); !taken) return taken;
  const auto watched = OpenWatched(arguments.watched, *table);
  if (!watched) return watched.error();
  std::filesystem::create_directories(arguments.out);
  TrainState state(MakeLayout(arguments.network, table->size()), *table, arguments.optimizer);
  state.network->to(options->device);
  state.average->to(options->device);
  if (const Status begun = Begin(arguments, **pictures, *options, state); !begun) return begun;
  std::printf("%s, %d classes, %zu pictures, from step %lld\n", arguments.network.c_str(), table->size(),
              (*pictures)->size(), static_cast<long long>(state.step));
  ShowAnchors(**pictures, state.network->layout, options->schedule.phases.back().sizes.front());
  const auto loader = MakeLoader(arguments, *pictures, *table, *options, Schedule(options->schedule, state.seconds));
  if (!loader) return loader.error();
  Trainer trainer(state, *loader, *watched, *options);
  CatchStopSignals();
  return trainer.Run(ShowProgress, IsStopAsked);
}

void AddLearningOptions(CLI::App& command, TrainArguments& arguments) {
  command
      .add_option("--sizes", arguments.sizes,
                  "Input size; sizes in turn: 320x256+416x320; or with the part of the training that they last: "
                  "224x192:0.4,320x256")
      ->capture_default_str();
  command.add_option("--batch", arguments.loader.batch_size, "Pictures a step")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.add_option("--rate", arguments.optimizer.rate, "Highest learning rate (AdamW)")->capture_default_str();
  command.add_option("--backbone-rate", arguments.optimizer.backbone_part, "The backbone's, in parts of it")
      ->capture_default_str();
  command.add_option("--weight-decay", arguments.optimizer.weight_decay)->capture_default_str();
  command.add_option("--averaging", arguments.optimizer.averaging, "Memory of the averaged weights, a step")
      ->capture_default_str();
  command.add_option("--mosaic", arguments.loader.compose.mosaic, "Share of pictures put together of four")
      ->capture_default_str();
  command
      .add_option("--close-ups", arguments.loader.compose.close_up,
                  "Share of the other pictures that look closely at one thing")
      ->capture_default_str();
  command.add_option("--zoom", arguments.loader.compose.zoom, "Mean enlargement of the others")->capture_default_str();
  command.add_option("--paste", arguments.loader.people.share, "Share of pictures into which people are pasted")
      ->capture_default_str();
  command
      .add_option("--unjudged", arguments.trainer.loss.unjudged,
                  "How much a class counts where a picture is not judged for it, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command.add_option("--warmup", arguments.trainer.schedule.num_warmup_steps, "Steps of rising learning rate")
      ->capture_default_str();
  command.add_option("--seed", arguments.loader.seed, "Of order, augmentation and first weights")
      ->capture_default_str();
}

}  // namespace

void AddTrainCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<TrainArguments>();
  CLI::App* command = program.add_subcommand("train", "Train a detector, or go on with a training");
  command->add_option("PACK", arguments->packs, "Packs of pictures to learn from")->required();
  command->add_option("--out", arguments->out, "Folder for checkpoints and logs")->required();
  command->add_option("--classes", arguments->classes, "The table of the network's classes")->required();
  command->add_option("--network", arguments->network, "yolo-mo, yolo-mo-n, yolov5n or yolov5s")
      ->check(CLI::IsMember(LayoutNames()))
      ->capture_default_str();
  command->add_option("--backbone", arguments->backbone, "ImageNet weights to begin from (TorchScript archive)");
  command->add_option("--weights", arguments->weights,
                      "Averaged weights of a checkpoint, or an exported ONNX file, to begin from");
  command->add_option("--teacher", arguments->teacher,
                      "A YOLOv5n or YOLOv5s (ONNX, three heads) to learn from as well");
  command->add_option("--teacher-weight", arguments->trainer.teacher_weight, "Its weight against the truth's")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  command->add_option("--people", arguments->people, "Folder of cut-outs of people to paste");
  command->add_option("--watch", arguments->watched, "Packs to measure on now and then");
  command->add_option("--epochs", arguments->epochs, "Length of the training in rounds through all pictures");
  command->add_option("--minutes", arguments->minutes, "Length of the training in minutes, instead");
  command->add_flag("--resume", arguments->should_resume, "Go on with OUT/last.pt where there is one");
  command->add_option("--threads", arguments->num_threads, "Threads of the network, on the CPU")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--loaders", arguments->trainer.num_loading_threads, "Threads beside it that make batches")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--device", arguments->device, "cpu, cuda or cuda:1")->capture_default_str();
  command->add_flag("--bfloat16", arguments->trainer.is_half_wide,
                    "Convolve in bfloat16 (a GPU, or a CPU with AVX-512 BF16 or AMX)");
  command->add_option("--evaluate-every", arguments->trainer.evaluate_every_s, "Seconds between two measurements")
      ->capture_default_str();
  AddLearningOptions(*command, *arguments);
  command->callback([arguments, &action] { action = [arguments] { return Train(*arguments); }; });
}

}  // namespace yorb

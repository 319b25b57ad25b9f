// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/sequence_arguments.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "camera/camera_io.h"
#include "core/text.h"
#include "datasets/open_dataset.h"
#include "evaluation/trajectory_io.h"
#include "map/map_file.h"
#include "system/config_io.h"

namespace yorb {
namespace {

/// What stands free on the command line: the one folder, and settings in the manner of `--set a=1 b=2`.
struct Places {
  std::string folder;
  std::vector<std::string> settings;
};

Result<Places> SortPlaces(const std::vector<std::string>& words) {
  Places places;
  std::vector<std::string> folders;
  for (const std::string& word : words) {
    std::error_code ignored;
    const bool is_setting =
        words.size() > 1 && word.find('=') != std::string::npos && !std::filesystem::exists(word, ignored);
    (is_setting ? places.settings : folders).push_back(word);
  }
  if (folders.empty()) return BadInput("the folder of a sequence is missing");
  if (folders.size() > 1) return BadInput("one folder is expected, not two: " + folders[0] + " and " + folders[1]);
  places.folder = folders.front();
  return places;
}

/// The settings of the command line in the order in which they are laid over the config file's.
Result<std::vector<Setting>> SettingsOf(const SequenceArguments& options, const std::vector<std::string>& more) {
  std::vector<Setting> settings;
  std::vector<std::string> texts = options.settings;
  texts.insert(texts.end(), more.begin(), more.end());
  for (const std::string& text : texts) {
    auto setting = ParseSetting(text, "--set");
    if (!setting) return setting.error();
    settings.push_back(*std::move(setting));
  }
  const auto add = [&](const char* key, const std::string& option, const std::optional<std::string>& value) {
    if (value) settings.push_back({key, *value, option});
  };
  add("mode", "--mode", options.mode);
  add("dynamics", "--dynamics", options.dynamics);
  add("detections", "--detections", options.detections);
  add("masks", "--masks", options.masks);
  add("detection.model", "--model", options.model);
  add("seed", "--seed", options.seed);
  add("max_frames", "--max-frames", options.max_frames);
  return settings;
}

/// With a camera as given, as the config file has it, as the folder shows it, or as the map that is loaded knows it.
Result<std::unique_ptr<Dataset>> Open(const std::string& folder, const SequenceArguments& options,
                                      const std::string& camera_text, const std::string& load_map, Layout layout) {
  const bool is_named = options.camera || !camera_text.empty();
  if (!is_named && !load_map.empty() && !ShowsItsCamera(folder)) {
    if (const Status there = CheckLayout(folder, layout); !there) return there.error();
    const auto rig = ReadMapCamera(load_map);
    if (!rig) return rig.error();
    return OpenDataset(folder, ChosenCamera{*rig, "of the map " + load_map, false}, layout);
  }
  if (options.camera || camera_text.empty()) return OpenDataset(folder, options.camera.value_or(""), layout);
  const auto rig = ParseCameraFile(camera_text, options.config.value_or("") + ", group camera");
  if (!rig) return rig.error();
  return OpenDataset(folder, ChosenCamera{*rig, "of the config file", true}, layout);
}

void RefuseOption(CLI::App& command, const Refused& refused) {
  CLI::Option* option = command.get_option(refused.option);
  option->group("");  // not in the help
  option->each([refused](const std::string&) { throw CLI::ValidationError(refused.option, refused.why); });
}

/// Whether a setting alone makes another configuration.
bool IsDefault(const Setting& setting) {
  const auto config = WithSettings(Config(), {setting});
  return config && ConfigText(*config, "") == ConfigText(Config(), "");
}

/// Settings that would be passed over in silence. The last one of a key counts; a config file of a run names all keys.
Status CheckTaken(const std::vector<Setting>& settings, const std::vector<Refused>& refused) {
  for (const Refused& one : refused) {
    const auto last =
        std::find_if(settings.rbegin(), settings.rend(), [&](const Setting& s) { return s.key == one.key; });
    if (last == settings.rend() || last->value == one.is_done || IsDefault(*last)) continue;
    return BadInput(last->origin + ": " + one.key + ": " + one.why);
  }
  return Status::Ok();
}

}  // namespace

void SequenceArguments::AddTo(CLI::App& command, const std::vector<Refused>& not_taken) {
  refused = not_taken;
  command.add_option("DIR", places, "The folder of the sequence, with rgb.txt and depth.txt or associations.txt")
      ->required()
      ->expected(1, -1);
  command.add_option(
      "--camera", camera,
      "A camera file, or tum_fr1, tum_fr2, tum_fr3; may be left out where the folder, or a map that is loaded, "
      "says which");
  command.add_option("--config", config,
                     "A YAML file with the settings that differ from the default (configs/default.yaml lists all)");
  command.add_option("--set", settings, "One setting, such as features.wanted=1200; may be given often")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command.add_option("--mode", mode,
                     "inline: one thread, same seed, same bits; offline (the default): threads, no frame left out; "
                     "live: at the pace of the time stamps");
  command.add_option(
      "--dynamics", dynamics,
      "What is done about moving things: full (the default): their boxes are followed, depth tells the body from the "
      "background, and whatever else moves is found by geometry; paper: points in their boxes are removed; exact: the "
      "same with boxes that are given; off: nothing");
  command.add_option("--detections", detections,
                     "A file with boxes in the detector's place: people.txt, or JSON lines of `yorb detect --json`");
  command.add_option(
      "--masks", masks,
      "A folder of PNGs named as the pictures or by their time stamps, or one PNG for all: what is not 0 "
      "is not used");
  command.add_option("--model", model,
                     "The detector's network, any YOLO export in ONNX; left out: models/yolo_mo.onnx");
  command.add_option("--seed", seed, "Of everything that is drawn by chance");
  command.add_option("--max-frames", max_frames, "Only the first so many colour pictures");
  for (const Refused& one : refused) {
    if (one.option[0] != '\0') RefuseOption(command, one);
  }
}

Result<long long> WholeNumber(const std::string& option, const std::string& text, long long least, long long most) {
  const auto number = ParseInteger(Trim(text));
  if (number && *number >= least && *number <= most) return *number;
  return BadInput(option + " must be a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
                  ", not " + text);
}

Result<long long> WholeNumber(const std::string& option, const std::optional<std::string>& text, long long otherwise,
                              long long least, long long most) {
  return text ? WholeNumber(option, *text, least, most) : otherwise;
}

Result<OpenedSequence> OpenSequence(const SequenceArguments& options) {
  OpenedSequence opened;
  const auto places = SortPlaces(options.places);
  if (!places) return places.error();
  opened.folder = places->folder;
  ConfigFile file;
  if (options.config) {
    auto read = ReadConfigFile(*options.config);
    if (!read) return read.error();
    file = *std::move(read);
  }
  const auto own = SettingsOf(options, places->settings);
  if (!own) return own.error();
  std::vector<Setting> settings = file.settings;
  settings.insert(settings.end(), own->begin(), own->end());
  auto config = WithSettings(Config(), settings);
  if (!config) return config.error();
  if (const Status taken = CheckTaken(settings, options.refused); !taken) return taken.error();
  opened.config = *std::move(config);
  const Status valid = ValidateConfig(opened.config);
  if (!valid) return valid.error();
  if (opened.config.max_frames == 0 && options.max_frames) return BadInput("--max-frames: 0; at least 1 is expected");
  const Layout layout = opened.config.localize_only ? Layout::kAnyPictures : Layout::kRecording;
  auto dataset = Open(opened.folder, options, file.camera_text, opened.config.load_map, layout);
  if (!dataset) return dataset.error();
  opened.dataset = *std::move(dataset);
  return opened;
}

Result<Trajectory> ReadTruthBeside(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / "groundtruth.txt").string();
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return Trajectory();
  auto truth = ReadTrajectoryFile(path);
  if (!truth) return truth.error();
  return std::move(truth->poses);
}

}  // namespace yorb

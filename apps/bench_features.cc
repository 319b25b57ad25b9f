// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/bench_features.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "apps/sequence_arguments.h"
#include "apps/signals.h"
#include "core/files.h"
#include "experiments/features.h"
#include "experiments/features_figures.h"
#include "runs/run_folder.h"
#include "system/config_io.h"

namespace yorb {
namespace {

constexpr long long kMostPictures = 1000000;

struct FeaturesArguments {
  std::vector<std::string> places;
  std::string camera, out;
  std::optional<std::string> config, pictures;
  std::vector<std::string> settings;
  bool wants_json = false;
};

Result<FeatureOptions> FeatureOptionsOf(const FeaturesArguments& arguments) {
  std::vector<Setting> settings;
  if (arguments.config) {
    const auto file = ReadConfigFile(*arguments.config);
    if (!file) return file.error();
    settings = file->settings;
  }
  for (const std::string& text : arguments.settings) {
    auto setting = ParseSetting(text, "--set");
    if (!setting) return setting.error();
    settings.push_back(*std::move(setting));
  }
  Config usual;
  usual.features.over_extraction = 1;  // nothing is removed here
  const auto config = WithSettings(usual, settings);
  if (!config) return config.error();
  if (const Status valid = ValidateConfig(*config); !valid) return valid.error();
  return config->features;
}

/// Tables and figures go by the names of the places; of two with one name the second is numbered.
Result<std::vector<PictureSet>> OpenSets(const FeaturesArguments& arguments) {
  std::vector<PictureSet> sets;
  std::set<std::string> names;
  for (const std::string& place : arguments.places) {
    auto set = OpenPictureSet(place, arguments.camera);
    if (!set) return set.error();
    set->name = UntakenPath(set->name, names);
    sets.push_back(*std::move(set));
  }
  return sets;
}

/// Figures of every set, and the report as text and JSON.
Status WriteResults(const std::string& folder, const std::vector<PictureSet>& sets, const FeatureOptions& features,
                    const std::vector<FeaturesReport>& reports) {
  std::vector<FileToWrite> files = {{folder + "/features.txt", FeaturesText(reports)},
                                    {folder + "/features.json", FeaturesJson(reports)}};
  for (const PictureSet& set : sets) {
    const auto figures = FeatureFigures(set, features, folder);
    if (!figures) return figures.error();
    files.insert(files.end(), figures->begin(), figures->end());
  }
  return WriteFilesTogether(files);
}

int BenchFeatures(const FeaturesArguments& arguments) {
  CatchSignals();
  FeaturesBenchOptions options;
  const auto features = FeatureOptionsOf(arguments);
  if (!features) return Complain(features.error());
  options.features = *features;
  const auto pictures =
      WholeNumber("--pictures", arguments.pictures, static_cast<long long>(options.pictures), 0, kMostPictures);
  if (!pictures) return Complain(pictures.error());
  options.pictures = static_cast<size_t>(*pictures);
  options.should_stop = IsStopAsked;
  const auto sets = OpenSets(arguments);
  if (!sets) return Complain(sets.error());
  if (!arguments.out.empty()) {
    if (const Status usable = PrepareRunFolder(arguments.out); !usable) return Complain(usable.error());
  }
  std::vector<FeaturesReport> reports;
  for (const PictureSet& set : *sets) {
    auto report = MeasureFeatures(set, options);
    if (!report) return Complain(report.error());
    reports.push_back(*std::move(report));
  }
  std::fputs((arguments.wants_json ? FeaturesJson(reports) : FeaturesText(reports)).c_str(), stdout);
  if (!arguments.out.empty()) {
    const Status written = WriteResults(arguments.out, *sets, options.features, reports);
    if (!written) return Complain(written.error());
  }
  return ExitCodeAfterSignal(kExitDone);
}

}  // namespace

void AddBenchFeatures(CLI::App& bench, Action& action) {
  CLI::App* command = bench.add_subcommand(
      "features", "Tables and figures on features: counts under changing light, spread, time, matches");
  const auto arguments = std::make_shared<FeaturesArguments>();
  command
      ->add_option("PLACE", arguments->places,
                   "Folders of pictures, pictures, or sequences (with a groundtruth.txt: matches along the motion)")
      ->required()
      ->expected(1, -1);
  command->add_option("--camera", arguments->camera, "Of the sequences: a camera file or tum_fr1, tum_fr2, tum_fr3");
  command->add_option("--config", arguments->config, "A YAML file with settings; those of features count");
  command->add_option("--set", arguments->settings, "One setting, such as features.fast_arc=12; may be given often")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_option("--pictures", arguments->pictures, "Of each place, evenly spread; 0: all [100]");
  command->add_flag("--json", arguments->wants_json, "JSON on standard output");
  command->add_option("--out", arguments->out, "A folder for the figures (PNG, SVG) and the report");
  command->footer(
      "Examples:\n"
      "  yorb bench features my_pictures\n"
      "  yorb bench features rgbd_dataset_freiburg1_xyz my_pictures --json --out figures");
  command->callback([arguments, &action] { action = [arguments] { return BenchFeatures(*arguments); }; });
}

}  // namespace yorb

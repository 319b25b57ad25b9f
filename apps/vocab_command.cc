// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/progress.h"
#include "apps/sequence_arguments.h"
#include "apps/signals.h"
#include "core/files.h"
#include "core/log.h"
#include "core/parallel.h"
#include "core/stopwatch.h"
#include "core/text.h"
#include "places/vocabulary_io.h"
#include "runs/learn_vocabulary.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

/// The options as they were written: numbers are read by us, so that complaints are ours.
struct TrainArguments {
  std::vector<std::string> places;
  std::string out;
  std::optional<std::string> branching, levels, seed, most_pictures, threads;
  bool is_quiet = false;
};

Result<LearningOptions> OptionsOf(const TrainArguments& a) {
  LearningOptions options;
  const auto branching = WholeNumber("--branching", a.branching, options.training.branching, 2, kMostBranches);
  const auto levels = WholeNumber("--levels", a.levels, options.training.levels, 1, kMostTreeLevels);
  const auto seed = WholeNumber("--seed", a.seed, options.training.seed, 0, std::numeric_limits<long long>::max());
  const auto most_pictures =
      WholeNumber("--max-pictures", a.most_pictures, static_cast<long long>(options.most_pictures), 1, 1000000);
  const auto threads = WholeNumber("--threads", a.threads, NumHardwareThreads(), 1, 1024);
  for (const auto* number : {&branching, &levels, &seed, &most_pictures, &threads}) {
    if (!*number) return number->error();
  }
  options.training.branching = static_cast<int>(*branching), options.training.levels = static_cast<int>(*levels);
  options.training.seed = *seed;
  options.training.num_threads = static_cast<int>(*threads);
  options.most_pictures = static_cast<size_t>(*most_pictures);
  return options;
}

/// Whether the result can be written once it is there.
Status CheckOut(const std::string& out) {
  std::error_code ignored;
  if (out.empty() || fs::is_directory(out, ignored)) return BadInput("--out '" + out + "' must name a file");
  const bool has_content = fs::is_regular_file(out, ignored) && fs::file_size(out, ignored) > 0;
  if (has_content && !BeginsAsVocabulary(out))
    return BadInput("--out " + out + " is there and no vocabulary of this program; name another file");
  const std::string probe = out + ".probe";
  if (const Status written = WriteFileWhole(probe, ""); !written) return BadInput("--out: " + written.error().message);
  fs::remove(probe, ignored);
  return Status::Ok();
}

std::string TreeText(const Vocabulary& vocabulary) {
  return std::to_string(vocabulary.num_words()) + " words in a tree of " + std::to_string(vocabulary.branching()) +
         " branches and " + std::to_string(vocabulary.levels()) + " levels";
}

Status TrainAndWrite(const TrainArguments& arguments) {
  const Stopwatch watch;
  const auto options = OptionsOf(arguments);
  if (!options) return options.error();
  if (Status writable = CheckOut(arguments.out); !writable) return writable;
  Progress reading(arguments.is_quiet, "pictures"), training(arguments.is_quiet, "steps");
  LearningHooks hooks;
  hooks.should_stop = IsStopAsked;
  hooks.on_pictures = [&](size_t done, size_t all) { reading.Show(done, all); };
  hooks.on_training = [&](size_t done, size_t all) {
    reading.End();
    training.Show(done, all);
  };
  const auto learnt = LearnVocabulary(arguments.places, *options, hooks);
  reading.End();
  training.End();
  if (IsStopAsked()) return Status::Ok();
  if (!learnt) return learnt.error();
  if (Status written = WriteVocabulary(*learnt->vocabulary, arguments.out); !written) return written;
  if (!arguments.is_quiet) {
    std::printf("%s, from %zu points of %zu pictures, in %s s: %s\n", TreeText(*learnt->vocabulary).c_str(),
                learnt->num_points, learnt->num_pictures, FormatFixed(watch.seconds(), 1).c_str(),
                arguments.out.c_str());
  }
  return Status::Ok();
}

int Train(const TrainArguments& arguments) {
  CatchSignals();
  if (const Status started = StartLog({}); !started) return Complain(started.error());
  const Status done = TrainAndWrite(arguments);
  const Status stopped = StopLog();
  if (!done) return Complain(done.error());
  if (!stopped) return Complain(stopped.error());
  return ExitCodeAfterSignal(kExitDone);
}

int Info(const std::string& file, bool wants_json) {
  const auto vocabulary = ReadVocabulary(file);
  if (!vocabulary) return Complain(vocabulary.error());
  std::error_code ignored;
  const auto bytes = static_cast<uint64_t>(fs::file_size(file, ignored));
  if (wants_json) {
    nlohmann::ordered_json json;
    json["words"] = (*vocabulary)->num_words();
    json["branching"] = (*vocabulary)->branching();
    json["levels"] = (*vocabulary)->levels();
    json["digest"] = HexText((*vocabulary)->digest());
    json["bytes"] = bytes;
    std::printf("%s\n", json.dump().c_str());
  } else {
    std::printf("%s: %s, %" PRIu64 " bytes, digest %s\n", file.c_str(), TreeText(**vocabulary).c_str(), bytes,
                HexText((*vocabulary)->digest()).c_str());
  }
  return kExitDone;
}

void AddTrain(CLI::App& vocab, Action& action) {
  CLI::App* command = vocab.add_subcommand("train", "Learns a vocabulary from pictures of any kind");
  const auto a = std::make_shared<TrainArguments>();
  command->add_option("PLACES", a->places, "Pictures, folders, videos or sequences in TUM layout")
      ->required()
      ->type_name("PICTURE|FOLDER|VIDEO|SEQUENCE");
  command->add_option("--out", a->out, "The vocabulary; written whole or not at all")->required()->type_name("FILE");
  command->add_option("--branching", a->branching, "Children of each node of the tree [20]")->type_name("N");
  command->add_option("--levels", a->levels, "Of the tree; branching^levels words at most [4]")->type_name("N");
  command->add_option("--seed", a->seed, "Of where clusters begin; the same gives the same bits [1]")->type_name("N");
  command->add_option("--max-pictures", a->most_pictures, "Of more, so many are taken, evenly [5000]")->type_name("N");
  command->add_option("--threads", a->threads, "At most so many; the result is the same [all cores]")->type_name("N");
  command->add_flag("--quiet", a->is_quiet, "Nothing on standard output");
  command->footer(
      "A run takes it with --set places.vocabulary=FILE.\n"
      "Examples:\n"
      "  yorb vocab train holiday/ office.mp4 --out mine.yvoc\n"
      "  yorb vocab train pictures/ --levels 5 --max-pictures 20000 --out large.yvoc");
  command->callback([a, &action] { action = [a] { return Train(*a); }; });
}

void AddVocabInfo(CLI::App& vocab, Action& action) {
  CLI::App* command = vocab.add_subcommand("info", "Says what a vocabulary file holds, ours or ORBvoc.txt");
  const auto file = std::make_shared<std::string>();
  const auto wants_json = std::make_shared<bool>(false);
  command->add_option("FILE", *file, "The vocabulary")->required()->type_name("FILE");
  command->add_flag("--json", *wants_json, "As a JSON document");
  command->footer("Example:\n  yorb vocab info ORBvoc.txt --json");
  command->callback([=, &action] { action = [=] { return Info(*file, *wants_json); }; });
}

}  // namespace

void AddVocabCommand(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("vocab", "Vocabularies, by which places are recognised: trains one, looks into one");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n"
      "  yorb vocab train holiday/ office.mp4 --out mine.yvoc\n"
      "  yorb vocab info mine.yvoc");
  AddTrain(*command, action);
  AddVocabInfo(*command, action);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "training/build_pack.h"
#include "training/command.h"
#include "training/split.h"

namespace yorb {
namespace {

struct PackArguments {
  std::vector<std::string> folders;
  std::string out, rules, split;
  uint64_t seed = 1;
  BuildPackOptions options;
};

Status PackFiles(const std::vector<LabelledFile>& files, const std::string& out, const BuildPackOptions& options) {
  if (files.empty()) return BadInput(out + ": too few pictures are left for it; pack without --split");
  const auto show = [&](size_t done) {
    if (done % 500 == 0) std::printf("%zu of %zu pictures\n", done, files.size());
  };
  const Result<PackCounts> counts = BuildPack(files, out, options, show);
  if (!counts) return counts.error();
  std::printf("%s: %zu pictures, %zu boxes, %zu doubtful ones\n", out.c_str(), counts->num_pictures, counts->num_boxes,
              counts->num_doubtful);
  return Status::Ok();
}

/// OUT.pack becomes OUT.train.pack and OUT.val.pack.
std::string PartPath(const std::string& out, const std::string& part) {
  const std::filesystem::path path(out);
  return (path.parent_path() / (path.stem().string() + part + path.extension().string())).string();
}

Status PackFolders(const PackArguments& arguments) {
  std::vector<LabelledFile> files;
  for (const std::string& folder : arguments.folders) {
    const auto found = FindLabelledFiles(folder);
    if (!found) return found.error();
    files.insert(files.end(), found->begin(), found->end());
  }
  BuildPackOptions options = arguments.options;
  if (options.class_list.empty()) {
    const Result<std::string> list = FindClassList(arguments.folders.front());
    if (!list) return list.error();
    options.class_list = *list;
  }
  if (!arguments.rules.empty()) {
    const auto rules = ReadLabelRules(arguments.rules);
    if (!rules) return rules.error();
    options.rules = *rules;
  }
  if (arguments.split.empty()) return PackFiles(files, arguments.out, options);
  const Result<SplitRatio> ratio = ParseSplitRatio(arguments.split);
  if (!ratio) return ratio.error();
  const Split split = SplitFiles(files, *ratio, arguments.seed);
  const Status packed = PackFiles(split.train, PartPath(arguments.out, ".train"), options);
  return packed ? PackFiles(split.val, PartPath(arguments.out, ".val"), options) : packed;
}

}  // namespace

void AddPackCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<PackArguments>();
  CLI::App* command = program.add_subcommand("pack", "Put labelled pictures, reduced, into one file for training");
  command->add_option("FOLDER", arguments->folders, "Folders of pictures; labels of DIR/images/A are in DIR/labels/A")
      ->required();
  command->add_option("--out", arguments->out, "The file to write")->required();
  command->add_option("--size", arguments->options.long_side_px, "Longer side of the packed pictures in pixels")
      ->check(CLI::Range(32, 2048))
      ->capture_default_str();
  command->add_option("--class-list", arguments->options.class_list,
                      "The set's classes, in the order of their numbers (default: classes.txt in or around FOLDER)");
  command->add_option("--rules", arguments->rules, "Which classes which pictures are labelled for");
  command->add_option("--teacher", arguments->options.teacher,
                      "Folder of a teacher's boxes with confidence; those of .2 to .4 are neither true nor false");
  command->add_option("--split", arguments->split,
                      "Such as 4:1: write OUT.train.pack and OUT.val.pack, dealt out by chance");
  command->add_option("--seed", arguments->seed, "Of that chance")->capture_default_str();
  command->callback([arguments, &action] { action = [arguments] { return PackFolders(*arguments); }; });
}

}  // namespace yorb

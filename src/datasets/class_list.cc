// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The lists of classes that sets of labelled pictures carry.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/log.h"
#include "core/text.h"
#include "datasets/labelled_set.h"
#include "detection/class_names.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

constexpr long long kMostClasses = 100000;

struct NumberedName {
  long long number;
  std::string name;
};

/// "7 dining_table" or "7: dining_table"; nothing for a line that begins otherwise.
std::optional<NumberedName> SplitNumber(const std::string& line) {
  const size_t end = line.find_first_of(" \t:");
  const auto number = ParseInteger(line.substr(0, end));
  if (!number || end == std::string::npos) return std::nullopt;
  return NumberedName{*number, std::string(Trim(line.substr(end + 1)))};
}

Result<Names> ReadClassesTxt(const std::string& path) {
  const auto file = ReadTextFile(path);
  if (!file) return file.error();
  const bool is_numbered = std::all_of(file->lines.begin(), file->lines.end(),
                                       [](const TextLine& line) { return SplitNumber(line.text).has_value(); });
  Names names;
  for (const TextLine& line : file->lines) {
    const auto entry =
        is_numbered ? *SplitNumber(line.text) : NumberedName{static_cast<long long>(names.size()), line.text};
    const auto index = static_cast<size_t>(entry.number);
    if (entry.number < 0 || entry.number >= kMostClasses)
      return BadInput(file->Where(line) + ": the number of a class is out of range");
    if (names.size() <= index) names.resize(index + 1);
    if (!names[index].empty())
      return BadInput(file->Where(line) + ": the number " + std::to_string(entry.number) + " stands here twice");
    names[index] = entry.name;
  }
  if (names.empty()) return BadInput(path + " names no class");
  return names;
}

Error BadYaml(const std::string& path, const YAML::Mark& mark, const std::string& fault) {
  return BadInput(path + (mark.is_null() ? "" : ", line " + std::to_string(mark.line + 1)) + ": " + fault);
}

/// `names` of a data.yaml: a list, or names by number.
Result<Names> NamesOf(const YAML::Node& list, const std::string& path) {
  if (!list.IsSequence() && !list.IsMap())
    return BadYaml(path, list.Mark(), "names is no list; write names: [person, chair], or a line each");
  Names names;
  long long next = 0;
  for (const auto& entry : list) {
    const YAML::Node name = list.IsMap() ? entry.second : entry;
    if (!name.IsScalar()) return BadYaml(path, name.Mark(), "the name of a class must be a word");
    const auto number = list.IsMap() ? ParseInteger(entry.first.IsScalar() ? entry.first.Scalar() : "") : next++;
    if (!number) return BadYaml(path, name.Mark(), "a name of names has no number before it");
    if (*number < 0 || *number >= kMostClasses)
      return BadYaml(path, name.Mark(), "the number of a class is out of range");
    if (names.size() <= static_cast<size_t>(*number)) names.resize(static_cast<size_t>(*number) + 1);
    names[static_cast<size_t>(*number)] = name.Scalar();
  }
  if (names.empty()) return BadYaml(path, list.Mark(), "no class names follow");
  return names;
}

/// Of a data.yaml only `names` counts; its paths are those of whoever trained.
Result<Names> ReadDataYaml(const std::string& path) {
  const auto text = ReadWholeText(path);
  if (!text) return text.error();
  try {
    const YAML::Node file = YAML::Load(*text);
    if (file.IsMap() && file["names"]) return NamesOf(file["names"], path);
    return BadInput(path + " has no names: the list of its classes");
  } catch (const YAML::Exception& error) {
    return BadYaml(path, error.mark, "no valid YAML: " + error.msg);
  }
}

}  // namespace

Result<Names> ReadClassList(const std::string& folder) {
  std::error_code ignored;
  const auto at = [&](const char* name) { return (fs::path(folder) / name).string(); };
  if (fs::exists(at("classes.txt"), ignored)) return ReadClassesTxt(at("classes.txt"));
  for (const char* name : {"data.yaml", "data.yml"}) {
    if (fs::exists(at(name), ignored)) return ReadDataYaml(at(name));
  }
  // LabelImg writes its list among the labels.
  if (const auto list = (fs::path(folder) / "labels" / "classes.txt").string(); fs::exists(list, ignored))
    return ReadClassesTxt(list);
  LogWarning("no-class-list",
             folder + " has no list of its classes (classes.txt or data.yaml); they count as COCO's 80");
  return CocoNames();
}

}  // namespace yorb

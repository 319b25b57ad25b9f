// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The lists of classes that sets of labelled pictures carry.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <utility>

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

/// "7 dining_table"; nothing for a line that begins otherwise.
std::optional<NumberedName> SplitNumber(const std::string& line) {
  const size_t end = line.find_first_of(" \t");
  const auto number = ParseInteger(line.substr(0, end));
  if (!number || end == std::string::npos) return std::nullopt;
  return NumberedName{*number, std::string(Trim(line.substr(end)))};
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

/// A YAML text without its quotes and what follows as a comment.
std::string PlainYaml(std::string_view text) {
  text = Trim(text);
  if (!text.empty() && (text.front() == '\'' || text.front() == '"')) {
    const size_t end = text.find(text.front(), 1);
    return std::string(text.substr(1, end == std::string_view::npos ? end : end - 1));
  }
  return std::string(Trim(text.substr(0, text.find(" #"))));
}

/// The lines below `names:`, "0: person" or "- person".
Result<Names> NamesBelow(const TextFile& file, size_t line) {
  Names names;
  for (size_t i = line + 1; i < file.lines.size(); ++i) {
    const std::string_view text = file.lines[i].text;
    const size_t colon = text.find(':');
    const auto number = colon == std::string_view::npos ? std::nullopt : ParseInteger(Trim(text.substr(0, colon)));
    if (text.front() == '-') {
      names.push_back(PlainYaml(text.substr(1)));
    } else if (number) {
      if (*number < 0 || *number >= kMostClasses)
        return BadInput(file.Where(file.lines[i]) + ": the number of a class is out of range");
      if (names.size() <= static_cast<size_t>(*number)) names.resize(static_cast<size_t>(*number) + 1);
      names[static_cast<size_t>(*number)] = PlainYaml(text.substr(colon + 1));
    } else {
      break;
    }
  }
  if (names.empty()) return BadInput(file.Where(file.lines[line]) + ": no class names follow");
  return names;
}

/// Of a data.yaml only `names` counts; its paths are those of whoever trained.
Result<Names> ReadDataYaml(const std::string& path) {
  const auto file = ReadTextFile(path);
  if (!file) return file.error();
  for (size_t i = 0; i < file->lines.size(); ++i) {
    const std::string_view text = file->lines[i].text;
    if (text.substr(0, 6) != "names:") continue;
    std::string value(Trim(text.substr(6)));
    if (value.empty() || value.front() == '#') return NamesBelow(*file, i);
    std::optional<Names> names = ParseClassNames(PlainYaml(value));
    for (size_t k = i + 1; !names && k < file->lines.size(); ++k) {  // a list that goes on over lines
      value += " " + file->lines[k].text;
      names = ParseClassNames(PlainYaml(value));
    }
    if (names) return *names;
    return BadInput(file->Where(file->lines[i]) + ": names is no list; write names: [person, chair], or a line each");
  }
  return BadInput(path + " has no names: the list of its classes");
}

}  // namespace

Result<Names> ReadClassList(const std::string& folder) {
  std::error_code ignored;
  const auto at = [&](const char* name) { return (fs::path(folder) / name).string(); };
  if (fs::exists(at("classes.txt"), ignored)) return ReadClassesTxt(at("classes.txt"));
  for (const char* name : {"data.yaml", "data.yml"}) {
    if (fs::exists(at(name), ignored)) return ReadDataYaml(at(name));
  }
  return CocoNames();
}

}  // namespace yorb

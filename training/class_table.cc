// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/class_table.h"

#include <algorithm>
#include <cctype>

#include "core/text.h"

namespace yorb {
namespace {

constexpr int kMostClasses = 1000;

bool IsMotion(std::string_view word) { return word == "high" || word == "low" || word == "static"; }

}  // namespace

std::string BareName(const std::string& text) {
  std::string bare;
  for (const char letter : text) {
    if (letter == ' ' || letter == '_' || letter == '-') continue;
    bare += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return bare;
}

std::optional<int> ClassTable::Find(const std::string& name) const {
  const std::string wanted = BareName(name);
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& n) { return BareName(n) == wanted; });
  if (found == names.end()) return std::nullopt;
  return static_cast<int>(found - names.begin());
}

Result<ClassTable> ReadClassTable(const std::string& path) {
  const Result<TextFile> file = ReadTextFile(path);
  if (!file) return file.error();
  ClassTable table;
  for (const TextLine& line : file->lines) {
    const std::vector<std::string_view> words = SplitAtBlanks(line.text);
    const bool is_numbered = ParseInteger(words.front()).has_value() && words.size() > 1;
    if (is_numbered && ParseInteger(words.front()) != table.size())
      return BadInput(file->Where(line) + ": the classes are numbered 0, 1, 2 ...; here stands " +
                      std::string(words.front()) + " in place of " + std::to_string(table.size()));
    const std::string_view motion = words.size() == 3 ? words[2] : "";
    if (words.size() > 3 || (!is_numbered && words.size() > 1) || (words.size() == 3 && !IsMotion(motion)))
      return BadInput(file->Where(line) + ": a line is `number name` or `number name high|low|static`, not '" +
                      OneLine(line.text) + "'");
    const std::string name(is_numbered ? words[1] : words[0]);
    if (table.Find(name)) return BadInput(file->Where(line) + ": the class " + name + " stands here twice");
    table.names.push_back(name);
    table.motions.emplace_back(motion);
  }
  if (table.names.empty() || table.size() > kMostClasses)
    return BadInput(path + ": between 1 and " + std::to_string(kMostClasses) + " classes are expected, not " +
                    std::to_string(table.size()));
  return table;
}

}  // namespace yorb

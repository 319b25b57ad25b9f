// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/label_rules.h"

#include <algorithm>

#include "core/text.h"

namespace yorb {
namespace {

/// Adds what one word says to the rule; false where it says nothing known.
bool AddWord(std::string_view word, LabelRule& rule) {
  if (word == "squashed") return rule.is_squashed = true;
  if (word == "all") {
    rule.judged.set();
    return true;
  }
  const std::vector<std::string_view> ends = SplitAt(word, '-');
  const auto first = ParseInteger(ends.front()), last = ParseInteger(ends.back());
  if (ends.size() > 2 || !first || !last || *first < 0 || *last < *first || *last >= kMostPackedClasses) return false;
  for (long long i = *first; i <= *last; ++i) rule.judged.set(static_cast<size_t>(i));
  return true;
}

}  // namespace

Result<std::vector<LabelRule>> ReadLabelRules(const std::string& path) {
  const Result<TextFile> file = ReadTextFile(path);
  if (!file) return file.error();
  std::vector<LabelRule> rules;
  for (const TextLine& line : file->lines) {
    const std::vector<std::string_view> words = SplitAtBlanks(line.text);
    LabelRule rule;
    rule.prefix = words.front();
    for (size_t i = 1; i < words.size(); ++i) {
      if (!AddWord(words[i], rule))
        return BadInput(file->Where(line) + ": '" + OneLine(words[i]) +
                        "' is neither `all`, `squashed`, a class number under 128 nor a range such as 0-79");
    }
    rules.push_back(rule);
  }
  return rules;
}

LabelRule RuleFor(const std::string& picture_name, const std::vector<LabelRule>& rules) {
  const auto fits = [&](const LabelRule& rule) { return rule.prefix == "*" || picture_name.starts_with(rule.prefix); };
  const auto found = std::find_if(rules.begin(), rules.end(), fits);
  if (found != rules.end()) return *found;
  LabelRule all;
  all.judged.set();
  return all;
}

}  // namespace yorb

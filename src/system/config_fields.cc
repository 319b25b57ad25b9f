// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "system/config_fields.h"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/text.h"

namespace yorb {
namespace {

template <typename T>
std::string TextOf(const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    return value;
  } else if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_integral_v<T>) {
    return std::to_string(value);
  } else {
    return FormatShortest(value);
  }
}

template <typename T>
std::optional<T> Parse(const std::string& text) {
  if constexpr (std::is_same_v<T, bool>) {
    for (const char* yes : {"true", "True", "TRUE", "on", "yes"}) {
      if (text == yes) return true;
    }
    for (const char* no : {"false", "False", "FALSE", "off", "no"}) {
      if (text == no) return false;
    }
    return std::nullopt;
  } else if constexpr (std::is_integral_v<T>) {
    const auto number = ParseInteger(text);
    if (!number || !std::in_range<T>(*number)) return std::nullopt;
    return static_cast<T>(*number);
  } else if constexpr (std::is_floating_point_v<T>) {
    return ParseDouble(text);
  } else {
    return text;
  }
}

template <typename T>
std::string KindOf() {
  if constexpr (std::is_same_v<T, bool>) return "true or false";
  if constexpr (std::is_integral_v<T>) return "a whole number";
  if constexpr (std::is_floating_point_v<T>) return "a number";
  return "a text";
}

template <typename T>
bool Allows(const Range& range, const T& value) {
  const auto number = static_cast<double>(value);
  return number >= range.low && number <= range.high;  // false for NaN as well
}
template <typename T>
bool Allows(const OneOf& choice, const T& value) {
  return std::find(choice.words.begin(), choice.words.end(), TextOf(value)) != choice.words.end();
}
template <typename T>
bool Allows(const AnyValue&, const T& value) {
  if constexpr (std::is_floating_point_v<T>) return value - value == 0;  // neither NaN nor infinite
  return true;
}

template <typename T>
std::string Wanted(const Range& range) {
  return KindOf<T>() + " from " + FormatShortest(range.low) + " to " + FormatShortest(range.high);
}
template <typename T>
std::string Wanted(const OneOf& choice) {
  std::string words;
  for (size_t i = 0; i < choice.words.size(); ++i) {
    const char* joint = i == 0 ? "" : i + 1 == choice.words.size() ? " or " : ", ";
    words += joint + choice.words[i];
  }
  return words;
}
template <typename T>
std::string Wanted(const AnyValue&) {
  return KindOf<T>();
}

/// Visits a Config and collects its fields.
class Collector {
 public:
  Collector(std::string prefix, std::vector<ConfigField>& fields) : prefix_(std::move(prefix)), fields_(fields) {}

  template <typename T, typename Constraint>
  void operator()(const char* name, T& value, const Constraint& constraint) const {
    const auto set = [&value, constraint](const std::string& text) {
      const auto parsed = Parse<T>(text);
      if (!parsed || !Allows(constraint, *parsed)) return false;
      value = *parsed;
      return true;
    };
    fields_.push_back({prefix_ + name, TextOf(value), Wanted<T>(constraint), std::is_same_v<T, std::string>, set});
  }

  template <typename Group>
  void operator()(const char* name, Group& group) const {
    Group::Visit(group, Collector(prefix_ + name + ".", fields_));
  }

 private:
  std::string prefix_;
  std::vector<ConfigField>& fields_;
};

}  // namespace

std::vector<ConfigField> FieldsOf(Config& config) {
  std::vector<ConfigField> fields;
  Config::Visit(config, Collector("", fields));
  return fields;
}

}  // namespace yorb

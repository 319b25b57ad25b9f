// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/trajectory_columns.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "core/text.h"

namespace yorb {
namespace {

/// Lower case; what stands in brackets goes to `unit`; of the rest only letters and digits stay.
struct HeaderWord {
  std::string name, unit;
};

HeaderWord Normalize(std::string_view word) {
  HeaderWord result;
  bool is_unit = false;
  for (const char c : word) {
    if (c == '[' || c == '(') is_unit = true;
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) continue;
    (is_unit ? result.unit : result.name) += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

bool IsOneOf(const std::string& word, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* known) { return word == known; });
}

/// -2: not a word for time.
int TimeDecimals(HeaderWord word) {
  if (word.unit.empty()) {
    for (const char* unit : {"ns", "us", "ms"}) {
      const size_t length = word.name.size();
      if (length > 2 && word.name.compare(length - 2, 2, unit) == 0 && !IsOneOf(word.name, {"times", "stamps"})) {
        word = {word.name.substr(0, length - 2), unit};
        break;
      }
    }
  }
  // Beside whole seconds, nanoseconds are the rest of a stamp in two columns, which is not to be lost: two words for
  // time.
  if (IsOneOf(word.name, {"nsec", "nsecs", "nanosec", "nanosecs", "nanoseconds"})) return 9;
  if (!IsOneOf(word.name, {"timestamp", "timestamps", "time", "t", "stamp", "sec", "secs", "seconds"})) return -2;
  if (IsOneOf(word.unit, {"ns", "nsec"})) return 9;
  if (IsOneOf(word.unit, {"us", "usec"})) return 6;
  if (IsOneOf(word.unit, {"ms", "msec"})) return 3;
  return IsOneOf(word.unit, {"s", "sec"}) ? 0 : -1;
}

/// 0 to 2: position x to z; 3 to 6: quaternion x to w; -1: something else.
int PoseColumn(const std::string& name) {
  if (name.empty()) return -1;
  const size_t axis = std::string("xyzw").find(name.back());
  if (axis == std::string::npos) return -1;
  const std::string kind = name.substr(0, name.size() - 1);
  const bool is_quaternion =
      IsOneOf(kind, {"q", "quat", "quaternion", "orientation", "rot", "rotation", "qrs", "poseorientation"});
  if (is_quaternion) return 3 + static_cast<int>(axis);
  const bool is_position =
      IsOneOf(kind, {"", "t", "p", "pos", "position", "trans", "translation", "prsr", "prs", "poseposition"});
  return is_position && axis < 3 ? static_cast<int>(axis) : -1;
}

}  // namespace

std::optional<TrajectoryColumns> ColumnsFromHeader(const std::vector<std::string_view>& words) {
  constexpr size_t kUnknown = static_cast<size_t>(-1);
  size_t stamp = kUnknown;
  std::array<size_t, 7> pose;
  pose.fill(kUnknown);
  TrajectoryColumns columns;
  columns.count = words.size();
  for (size_t i = 0; i < words.size(); ++i) {
    const HeaderWord word = Normalize(words[i]);
    const int decimals = TimeDecimals(word), column = PoseColumn(word.name);
    if (decimals >= -1) {
      if (stamp != kUnknown) return std::nullopt;
      stamp = i;
      columns.stamp_decimals = decimals;
    } else if (column >= 0) {
      if (pose[static_cast<size_t>(column)] != kUnknown) return std::nullopt;
      pose[static_cast<size_t>(column)] = i;
    }
  }
  if (stamp == kUnknown || std::count(pose.begin(), pose.end(), kUnknown) > 0) return std::nullopt;
  columns.stamp = stamp;
  std::copy_n(pose.begin(), 3, columns.position.begin());
  std::copy_n(pose.begin() + 3, 4, columns.quaternion_xyzw.begin());
  return columns;
}

int StampDecimalsBySize(double stamp) {
  const double size = std::abs(stamp);
  if (size >= 1e17) return 9;
  if (size >= 1e14) return 6;
  return size >= 1e11 ? 3 : 0;
}

std::optional<Timestamp> ParseScaledStamp(std::string_view text, int decimals) {
  if (decimals <= 0) return ParseTimestamp(text);
  const size_t mantissa_end = std::min(text.find_first_of("eE"), text.size());
  long long exponent = 0;
  if (mantissa_end < text.size()) {
    const auto written = ParseInteger(text.substr(mantissa_end + 1));
    if (!written) return std::nullopt;
    exponent = std::clamp<long long>(*written, -1000, 1000);
  }
  return ParseTimestamp(std::string(text.substr(0, mantissa_end)) + "e" + std::to_string(exponent - decimals));
}

std::vector<std::string_view> SplitColumns(std::string_view line) {
  if (line.find(',') == std::string_view::npos) return SplitAtBlanks(line);
  std::vector<std::string_view> fields = SplitAt(line, ',');
  if (fields.back().empty()) fields.pop_back();
  return fields;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/class_names.h"

#include <cctype>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "core/text.h"

namespace yorb {
namespace {

/// Reads the text of a Python or JSON literal from left to right.
class LiteralReader {
 public:
  explicit LiteralReader(std::string_view text) : rest_(Trim(text)) {}

  bool Take(char letter) {
    SkipBlanks();
    if (rest_.empty() || rest_.front() != letter) return false;
    rest_.remove_prefix(1);
    return true;
  }

  bool is_at_end() {
    SkipBlanks();
    return rest_.empty();
  }

  std::optional<long long> Integer() {
    SkipBlanks();
    size_t length = 0;
    while (length < rest_.size() && std::isdigit(static_cast<unsigned char>(rest_[length]))) ++length;
    const auto value = ParseInteger(rest_.substr(0, length));
    if (value) rest_.remove_prefix(length);
    return value;
  }

  /// A text in quotes of either kind.
  std::optional<std::string> Quoted() {
    SkipBlanks();
    if (rest_.empty() || (rest_.front() != '\'' && rest_.front() != '"')) return std::nullopt;
    const char quote = rest_.front();
    rest_.remove_prefix(1);
    std::string text;
    while (!rest_.empty() && rest_.front() != quote) {
      const char letter = rest_.front();
      rest_.remove_prefix(1);
      if (letter == '\\') {
        AppendEscaped(text);
      } else {
        text += letter;
      }
    }
    if (!Take(quote)) return std::nullopt;
    return text;
  }

  /// A name as Python, JSON and YAML write it: 'cup', u'cup', b'cup', np.str_('cup'), cup. Nothing where there is none.
  std::optional<std::string> Name() {
    SkipBlanks();
    for (const std::string_view prefix : {"u", "b", "np.str_(", "numpy.str_("}) {
      if (!rest_.starts_with(prefix)) continue;
      LiteralReader behind(rest_.substr(prefix.size()));
      auto name = behind.Quoted();
      if (!name || (prefix.back() == '(' && !behind.Take(')'))) continue;
      *this = behind;
      return name;
    }
    if (auto name = Quoted()) return name;
    std::string word = Bare();
    if (word.empty()) return std::nullopt;
    return word;
  }

 private:
  /// A word without quotes, up to the next separator: as YAML's lists have them.
  std::string Bare() {
    const size_t end = std::min(rest_.find_first_of(",]}"), rest_.size());
    std::string word(Trim(rest_.substr(0, end)));
    rest_.remove_prefix(end);
    return word;
  }

  void SkipBlanks() {
    while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front()))) rest_.remove_prefix(1);
  }

  void AppendEscaped(std::string& text) {
    if (rest_.empty()) return;
    const char letter = rest_.front();
    rest_.remove_prefix(1);
    const size_t digits = letter == 'x' ? 2 : letter == 'u' ? 4 : 0;
    if (digits == 0) {
      text += letter == 'n' ? '\n' : letter == 't' ? '\t' : letter;
      return;
    }
    uint32_t code = 0;
    for (size_t i = 0; i < digits && !rest_.empty(); ++i) {
      const char digit = static_cast<char>(std::tolower(static_cast<unsigned char>(rest_.front())));
      code = code * 16 + static_cast<uint32_t>(digit <= '9' ? digit - '0' : digit - 'a' + 10);
      rest_.remove_prefix(1);
    }
    AppendUtf8(code, text);
  }

  static void AppendUtf8(uint32_t code, std::string& text) {
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xc0 | code >> 6);
      text += static_cast<char>(0x80 | (code & 0x3f));
    } else {
      text += static_cast<char>(0xe0 | (code >> 12 & 0xf));
      text += static_cast<char>(0x80 | (code >> 6 & 0x3f));
      text += static_cast<char>(0x80 | (code & 0x3f));
    }
  }

  std::string_view rest_;
};

std::optional<std::vector<std::string>> ParseDict(LiteralReader& reader) {
  std::map<long long, std::string> by_number;
  while (!reader.Take('}')) {
    const auto quoted = reader.Quoted();  // JSON has no other keys
    const auto number = quoted ? ParseInteger(*quoted) : reader.Integer();
    if (!number || !reader.Take(':')) return std::nullopt;
    auto name = reader.Name();
    if (!name) return std::nullopt;
    by_number[*number] = *std::move(name);
    if (!reader.Take(',') && !reader.Take('}')) return std::nullopt;
    if (reader.is_at_end()) break;
  }
  std::vector<std::string> names;
  for (auto& [number, name] : by_number) {
    if (number != static_cast<long long>(names.size())) return std::nullopt;
    names.push_back(std::move(name));
  }
  return names;
}

std::optional<std::vector<std::string>> ParseList(LiteralReader& reader, char end) {
  std::vector<std::string> names;
  for (bool has_more = true; !reader.Take(end); has_more = reader.Take(',')) {
    auto name = has_more ? reader.Name() : std::nullopt;
    if (!name) return std::nullopt;
    names.push_back(*std::move(name));
  }
  return names;
}

struct NumberedName {
  long long number;
  std::string name;
};

/// "7 dining_table" or "7: dining_table"; nothing for a line that begins otherwise, or ends there.
std::optional<NumberedName> SplitNumber(const std::string& line) {
  const size_t end = line.find_first_of(" \t:"), start = line.find_first_not_of(" \t:", end);
  const auto number = ParseInteger(line.substr(0, end));
  if (!number || start == std::string::npos) return std::nullopt;
  return NumberedName{*number, line.substr(start)};
}

/// Whether all lines begin with numbers of classes. Where there is no 0 and what follows is the same twice, they are
/// parts of the names: "20 km/h", "50 km/h".
bool AreNumbered(const std::vector<TextLine>& lines) {
  bool has_zero = false;
  std::set<std::string> names;
  for (const TextLine& line : lines) {
    const auto entry = SplitNumber(line.text);
    if (!entry) return false;
    has_zero |= entry->number == 0;
    names.insert(entry->name);
  }
  return has_zero || names.size() == lines.size();
}

}  // namespace

std::string FoldClassName(std::string_view name) {
  std::string folded;
  for (const char letter : Trim(name)) {
    if (letter == ' ' || letter == '_' || letter == '-') continue;
    folded += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return folded;
}

const std::vector<std::string>& CocoNames() {
  static const std::vector<std::string> names{
      "person",         "bicycle",    "car",           "motorcycle",    "airplane",     "bus",           "train",
      "truck",          "boat",       "traffic light", "fire hydrant",  "stop sign",    "parking meter", "bench",
      "bird",           "cat",        "dog",           "horse",         "sheep",        "cow",           "elephant",
      "bear",           "zebra",      "giraffe",       "backpack",      "umbrella",     "handbag",       "tie",
      "suitcase",       "frisbee",    "skis",          "snowboard",     "sports ball",  "kite",          "baseball bat",
      "baseball glove", "skateboard", "surfboard",     "tennis racket", "bottle",       "wine glass",    "cup",
      "fork",           "knife",      "spoon",         "bowl",          "banana",       "apple",         "sandwich",
      "orange",         "broccoli",   "carrot",        "hot dog",       "pizza",        "donut",         "cake",
      "chair",          "couch",      "potted plant",  "bed",           "dining table", "toilet",        "tv",
      "laptop",         "mouse",      "remote",        "keyboard",      "cell phone",   "microwave",     "oven",
      "toaster",        "sink",       "refrigerator",  "book",          "clock",        "vase",          "scissors",
      "teddy bear",     "hair drier", "toothbrush"};
  return names;
}

std::optional<std::vector<std::string>> ParseClassNames(std::string_view text) {
  LiteralReader reader(text);
  std::optional<std::vector<std::string>> names;
  if (reader.Take('{')) {
    names = ParseDict(reader);
  } else if (reader.Take('[')) {
    names = ParseList(reader, ']');
  } else if (reader.Take('(')) {
    names = ParseList(reader, ')');
  }
  if (!names || names->empty() || !reader.is_at_end()) return std::nullopt;
  return names;
}

Result<std::vector<std::string>> ReadClassList(const std::string& path) {
  const auto file = ReadTextFile(path);
  if (!file) return file.error();
  const bool are_numbered = AreNumbered(file->lines);
  std::vector<std::string> names;
  for (const TextLine& line : file->lines) {
    const auto entry =
        are_numbered ? *SplitNumber(line.text) : NumberedName{static_cast<long long>(names.size()), line.text};
    const auto index = static_cast<size_t>(entry.number);
    if (entry.number < 0 || entry.number >= kMostListedClasses)
      return BadInput(file->Where(line) + ": the number of a class is out of range");
    if (names.size() <= index) names.resize(index + 1);
    if (!names[index].empty())
      return BadInput(file->Where(line) + ": the number " + std::to_string(entry.number) + " stands here twice");
    names[index] = entry.name;
  }
  if (names.empty()) return BadInput(path + " names no class");
  return names;
}

std::string ClassNamesText(const std::vector<std::string>& names) {
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(i) + ": '";
    for (const char letter : names[i]) {
      if (letter == '\'' || letter == '\\') text += '\\';
      text += letter;
    }
    text += "'";
  }
  return "{" + text + "}";
}

std::vector<double> NumbersIn(std::string_view text) {
  std::vector<double> numbers;
  const std::string_view kParts = "0123456789.eE+-";
  while (true) {
    const size_t start = text.find_first_of("0123456789.+-");
    if (start == std::string_view::npos) return numbers;
    text.remove_prefix(start);
    const size_t end = std::min(text.find_first_not_of(kParts), text.size());
    if (const auto number = ParseDouble(text.substr(0, end))) numbers.push_back(*number);
    text.remove_prefix(end);
  }
}

}  // namespace yorb

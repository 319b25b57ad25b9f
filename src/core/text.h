// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace yorb {

/// One line of a text file that says something, without the blanks around it.
struct TextLine {
  int number = 0;  ///< from 1, as editors count
  std::string text;
};

/// A text file as people have them: byte-order mark, CRLF, tabs, blanks at the ends of lines, empty lines and
/// `#` comment lines are all passed over.
struct TextFile {
  std::string path;
  std::vector<TextLine> lines;
  std::vector<std::string> comments;  ///< the `#` lines, for the few formats whose header is one

  /// "path, line 12": the start of a complaint about that line.
  std::string Where(const TextLine& line) const { return path + ", line " + std::to_string(line.number); }
};

/// The text of a whole file as it is, without a byte-order mark; UTF-16 with one is turned to UTF-8. Bad input when it
/// is missing, a folder, unreadable, or holds zero bytes (is no text).
Result<std::string> ReadWholeText(const std::string& path);

/// Reads a text file line by line. Bad input when it is missing, a folder, unreadable, or holds zero bytes (is no
/// text).
Result<TextFile> ReadTextFile(const std::string& path);

/// `text` without blanks, tabs and line ends at both ends.
std::string_view Trim(std::string_view text);

/// The fields between runs of blanks and tabs.
std::vector<std::string_view> SplitAtBlanks(std::string_view text);

/// The fields between single separators, each trimmed; "a,,b" has three.
std::vector<std::string_view> SplitAt(std::string_view text, char separator);

/// Reads a whole field as a number with a decimal point, whatever the locale; exponents and a leading `+` are fine.
/// nan and inf are read as such; anything left over, or an empty field, gives nothing.
std::optional<double> ParseDouble(std::string_view text);

/// Reads a whole field as an integer.
std::optional<long long> ParseInteger(std::string_view text);

/// A number without a fraction, and below a billion, as an integer: tools write class 0 as 0.0.
std::optional<long long> WholeNumber(double number);

/// `value` with so many decimals and a decimal point in every locale.
std::string FormatFixed(double value, int decimals);

/// The shortest text that reads back as the same number, with a decimal point in every locale.
std::string FormatShortest(double value);

/// A picture's size: "640x480".
std::string SizeText(int width, int height);

/// Sixteen hexadecimal digits.
std::string HexText(uint64_t value);

/// In small letters; only those of ASCII are changed.
std::string LowerCase(std::string text);

/// The text as one line of bearable length, for a complaint or a log: control characters become blanks, and the middle
/// of more than 2000 bytes is left out.
std::string OneLine(std::string_view text);

/// How many letters must be put in, taken out or replaced to make one word the other.
size_t EditDistance(std::string_view a, std::string_view b);

/// The word of `known` nearest to `word` by edit distance, for "did you mean"; empty when `known` is.
std::string NearestWord(const std::string& word, const std::vector<std::string>& known);

}  // namespace yorb

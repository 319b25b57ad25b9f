// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/text.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <system_error>
#include <utility>

namespace yorb {
namespace {

void AddLine(TextFile& file, int number, std::string_view raw) {
  const std::string_view text = Trim(raw);
  if (text.empty()) return;
  if (text.front() == '#') {
    file.comments.emplace_back(text);
  } else {
    file.lines.push_back({number, std::string(text)});
  }
}

/// What a number too large or too small for a double stands for: infinity or zero. std::from_chars does not say which.
double BeyondDouble(std::string_view text) {
  const size_t mantissa_end = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, mantissa_end);
  const auto point = static_cast<long long>(std::min(mantissa.find('.'), mantissa.size()));
  const auto first_digit = static_cast<long long>(std::min(mantissa.find_first_of("123456789"), mantissa.size()));
  const std::string_view exponent_text = text.substr(std::min(mantissa_end + 1, text.size()));
  // An exponent that is no long long outweighs any mantissa.
  const long long weighty = exponent_text.substr(0, 1) == "-" ? -1'000'000'000'000 : 1'000'000'000'000;
  const long long exponent = exponent_text.empty() ? 0 : ParseInteger(exponent_text).value_or(weighty);
  const double magnitude = point - first_digit + exponent > 0 ? HUGE_VAL : 0.0;
  return text.front() == '-' ? -magnitude : magnitude;
}

void AppendUtf8(uint32_t letter, std::string& text) {
  const auto add = [&text](uint32_t bits) { text += static_cast<char>(bits); };
  if (letter < 0x80) return add(letter);
  if (letter < 0x800) {
    add(0xc0 | letter >> 6);
  } else {
    if (letter < 0x10000) add(0xe0 | letter >> 12);
    if (letter >= 0x10000) {
      add(0xf0 | letter >> 18);
      add(0x80 | (letter >> 12 & 0x3f));
    }
    add(0x80 | (letter >> 6 & 0x3f));
  }
  add(0x80 | (letter & 0x3f));
}

/// What PowerShell's `>` writes: UTF-16 with a byte-order mark.
std::string FromUtf16(const std::string& content) {
  const bool is_little = content.compare(0, 2, "\xff\xfe") == 0;
  const auto unit = [&](size_t at) -> uint32_t {
    const auto first = static_cast<unsigned char>(content[at]), second = static_cast<unsigned char>(content[at + 1]);
    return is_little ? first | second << 8 : first << 8 | second;
  };
  std::string text;
  for (size_t at = 2; at + 1 < content.size(); at += 2) {
    uint32_t letter = unit(at);
    if (letter >= 0xd800 && letter < 0xdc00 && at + 3 < content.size()) {
      letter = 0x10000 + ((letter - 0xd800) << 10) + ((unit(at + 2) - 0xdc00) & 0x3ff);
      at += 2;
    }
    AppendUtf8(letter, text);
  }
  return text;
}

Error CannotRead(const std::string& path, int reason) {
  if (reason == ENOENT) return BadInput(path + " does not exist");
  if (reason == EISDIR) return BadInput(path + " is a folder, a text file is expected");
  return BadInput(path + " cannot be read: " + std::generic_category().message(reason));
}

/// All bytes of a file, or of a pipe. A named pipe that nobody writes to counts as empty: waiting for it has no end.
Result<std::string> ReadBytes(const std::string& path) {
  constexpr size_t kLargest = size_t{1} << 30, kPiece = size_t{1} << 18;
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file < 0) return CannotRead(path, errno);
  ::fcntl(file, F_SETFL, O_RDONLY);  // one that somebody writes to is waited for
  std::string content;
  ssize_t count = 1;
  while (count > 0 && content.size() <= kLargest) {
    const size_t size = content.size();
    content.resize(size + kPiece);
    do count = ::read(file, &content[size], kPiece);
    while (count < 0 && errno == EINTR);
    content.resize(size + static_cast<size_t>(std::max<ssize_t>(count, 0)));
  }
  const int reason = errno;
  ::close(file);
  if (count < 0) return CannotRead(path, reason);
  if (content.size() > kLargest) return BadInput(path + " is larger than 1 GiB, a text file is expected");
  return content;
}

}  // namespace

Result<std::string> ReadWholeText(const std::string& path) {
  auto read = ReadBytes(path);
  if (!read) return read.error();
  std::string content = *std::move(read);
  const std::string mark = content.substr(0, 2);
  if (mark == "\xff\xfe" || mark == "\xfe\xff") content = FromUtf16(content);
  if (content.find('\0') != std::string::npos) return BadInput(path + " is no text file: it holds zero bytes");
  if (content.compare(0, 3, "\xef\xbb\xbf") == 0) content.erase(0, 3);
  return content;
}

Result<TextFile> ReadTextFile(const std::string& path) {
  const auto content = ReadWholeText(path);
  if (!content) return content.error();
  TextFile file;
  file.path = path;
  std::string_view rest = *content;
  for (int number = 1; !rest.empty(); ++number) {
    const size_t end = rest.find('\n');
    AddLine(file, number, rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return file;
}

std::string_view Trim(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n\v\f";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> SplitAtBlanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n\v\f";
  std::vector<std::string_view> fields;
  size_t start = text.find_first_not_of(kBlanks);
  while (start != std::string_view::npos) {
    const size_t end = std::min(text.find_first_of(kBlanks, start), text.size());
    fields.push_back(text.substr(start, end - start));
    start = text.find_first_not_of(kBlanks, end);
  }
  return fields;
}

std::vector<std::string_view> SplitAt(std::string_view text, char separator) {
  std::vector<std::string_view> fields;
  while (true) {
    const size_t end = text.find(separator);
    fields.push_back(Trim(text.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    text.remove_prefix(end + 1);
  }
}

std::optional<double> ParseDouble(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || end != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return BeyondDouble(text);
  if (error != std::errc()) return std::nullopt;
  return value;
}

std::optional<long long> ParseInteger(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<long long> WholeNumber(double number) {
  constexpr double kMost = 1e9;
  const bool is_whole = std::abs(number) < kMost && number == std::floor(number);
  return is_whole ? std::optional(static_cast<long long>(number)) : std::nullopt;
}

std::string FormatFixed(double value, int decimals) {
  char buffer[400];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::fixed, decimals);
  return error == std::errc() ? std::string(buffer, end) : FormatShortest(value);
}

std::string FormatShortest(double value) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return error == std::errc() ? std::string(buffer, end) : std::string("0");
}

std::string SizeText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

std::string HexText(uint64_t value) {
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[value >> shift & 15];
  return text;
}

std::string LowerCase(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

std::string OneLine(std::string_view text) {
  constexpr size_t kMost = 2000, kHead = 1200, kTail = 600;
  const auto is_inside_letter = [&](size_t at) { return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80; };
  std::string line;
  if (text.size() <= kMost) {
    line = text;
  } else {
    size_t head = kHead, tail = text.size() - kTail;
    while (head > kHead - 4 && is_inside_letter(head)) --head;
    while (tail < text.size() - kTail + 4 && is_inside_letter(tail)) ++tail;
    line.append(text.substr(0, head)).append(" ... ").append(text.substr(tail));
  }
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  std::replace_if(line.begin(), line.end(), is_control, ' ');
  return line;
}

size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = std::exchange(row[0], i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replace = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replace});
    }
  }
  return row[b.size()];
}

std::string NearestWord(const std::string& word, const std::vector<std::string>& known) {
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return EditDistance(word, a) < EditDistance(word, b);
  });
  return nearest == known.end() ? std::string() : *nearest;
}

}  // namespace yorb

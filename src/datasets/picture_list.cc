// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/picture_list.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "core/log.h"
#include "core/stats.h"
#include "pictures/endings.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr double kLongestStep = 10;     // seconds between neighbours (median) beyond which stamps are no seconds
constexpr double kShortestStep = 1e-4;  // seconds below which they are no seconds either
constexpr double kStrangeStep = 0.5;    // seconds beyond which they may be frame numbers

bool IsDigits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

std::string_view Unquoted(std::string_view text) {
  const bool is_quoted =
      text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

/// A list line in two: the stamp and the rest.
struct StampAndRest {
  std::string_view stamp, rest;
};

StampAndRest SplitLine(std::string_view line) {
  const size_t blank = std::min(line.find_first_of(" \t"), line.size());
  std::string_view stamp = line.substr(0, blank), rest = Trim(line.substr(blank));
  if (!ParseTimestamp(stamp)) {
    const size_t comma = line.find_first_of(",;");
    const bool is_separator = comma < line.size() && ParseTimestamp(Trim(line.substr(0, comma))) &&
                              !IsDigits(line.substr(comma + 1, blank > comma ? blank - comma - 1 : 0));
    if (is_separator) stamp = Trim(line.substr(0, comma)), rest = Trim(line.substr(comma + 1));
  }
  while (!rest.empty() && (rest.front() == ',' || rest.front() == ';')) rest = Trim(rest.substr(1));
  return {stamp, rest};
}

/// "timestamp filename" without a `#` before it.
bool IsHeading(const std::vector<TextLine>& lines, size_t index) {
  return index == 0 && std::isalpha(static_cast<unsigned char>(lines[0].text.front())) &&
         !HasPictureEnding(lines[0].text);
}

}  // namespace

std::vector<Timestamp> PictureList::Times() const {
  std::vector<Timestamp> times;
  for (const ListedPicture& picture : pictures) times.push_back(picture.time);
  return times;
}

Result<Timestamp> ReadStamp(std::string_view text, const std::string& where) {
  if (const auto time = ParseTimestamp(text)) return *time;
  const std::string start = where + ": '" + std::string(text) + "' ";
  if (const auto number = ParseDouble(text); number && std::isfinite(*number)) {
    return BadInput(start +
                    "is no time in seconds; if it counts nanoseconds (or micro- or milliseconds), write seconds "
                    "with a decimal point");
  }
  const auto comma = text.find(',');
  if (comma != text.npos && IsDigits(text.substr(0, comma)) && IsDigits(text.substr(comma + 1))) {
    return BadInput(start + "is no time stamp: numbers are written with a decimal point");
  }
  return BadInput(start + "is no time stamp; a line is 'timestamp file'");
}

ListedPicture LocatePicture(const std::string& folder, std::string_view text) {
  const auto path_of = [&](const std::string& name) { return (fs::path(folder) / name).lexically_normal().string(); };
  std::error_code ignored;
  const std::string whole(Unquoted(Trim(text)));
  const bool is_plain = whole.find_first_of(" \t\\,;\"'") == std::string::npos;
  std::vector<std::string> readings{whole};
  if (!is_plain) {
    std::string forward = whole;  // as Windows writes paths
    std::replace(forward.begin(), forward.end(), '\\', '/');
    readings.push_back(forward);
    for (const std::string& reading : {whole, forward}) {  // further columns after the name
      readings.push_back(std::string(Unquoted(Trim(reading.substr(0, reading.find_first_of(" \t,;"))))));
    }
    for (const std::string& reading : readings) {
      if (fs::is_regular_file(path_of(reading), ignored)) return {{}, reading, path_of(reading), 0};
    }
  }
  const std::string& name = HasPictureEnding(readings.back()) ? readings.back() : readings.front();
  return {{}, name, path_of(name), 0};
}

Result<PictureList> ReadPictureList(const std::string& path) {
  const auto text = ReadTextFile(path);
  if (!text) return text.error();
  PictureList list{path, {}};
  const std::string folder = fs::path(path).parent_path().string();
  for (size_t i = 0; i < text->lines.size(); ++i) {
    const TextLine& line = text->lines[i];
    if (IsHeading(text->lines, i)) continue;
    const StampAndRest parts = SplitLine(line.text);
    const auto time = ReadStamp(parts.stamp, text->Where(line));
    if (!time) return time.error();
    if (parts.rest.empty()) return BadInput(text->Where(line) + ": no file name behind the time stamp");
    list.pictures.push_back(LocatePicture(folder, parts.rest));
    list.pictures.back().time = *time;
    list.pictures.back().line = line.number;
  }
  if (list.pictures.empty()) return BadInput(path + " names no picture");
  return list;
}

Status CheckStamps(const PictureList& list) {
  for (size_t i = 1; i < list.pictures.size(); ++i) {
    const ListedPicture &before = list.pictures[i - 1], &here = list.pictures[i];
    if (before.time < here.time) continue;
    const bool is_repeated = before.time == here.time;
    return BadInput(
        list.file + ", line " + std::to_string(here.line) + ": time stamp " + ToString(here.time) +
        (is_repeated ? " repeats that of line " : " goes back behind " + ToString(before.time) + " of line ") +
        std::to_string(before.line) + "; stamps must increase");
  }
  const double step = MedianStep(list.Times());
  if (step > kLongestStep) {
    return BadInput(list.file + ": time stamps are " + FormatShortest(step) +
                    " apart (median), so they are no seconds but counts or nanoseconds; write seconds");
  }
  if (list.pictures.size() > 1 && step < kShortestStep) {
    return BadInput(list.file + ": time stamps are " + FormatShortest(step) +
                    " apart (median), which is no camera's rate in seconds; write seconds");
  }
  if (const std::string strange = StrangeStamps(list); !strange.empty()) LogWarning("stamps", strange);
  return Status::Ok();
}

std::string StrangeStamps(const PictureList& list) {
  const double step = MedianStep(list.Times());
  if (step <= kStrangeStep) return "";
  return list.file + ": time stamps are " + FormatShortest(step) +
         " s apart (median); if they are frame numbers, write seconds";
}

}  // namespace yorb

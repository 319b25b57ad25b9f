// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/associations.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

#include "core/text.h"
#include "pictures/endings.h"
#include "pictures/picture_file.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

struct Column {
  std::string_view stamp, file;
};

std::vector<std::string_view> Words(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const size_t start = line.find_first_not_of(" \t,;");
    if (start == std::string_view::npos) break;
    line.remove_prefix(start);
    const bool is_quoted = line.front() == '"' || line.front() == '\'';
    const size_t close = is_quoted ? line.find(line.front(), 1) : std::string_view::npos;
    const size_t end = close != std::string_view::npos ? close + 1 : std::min(line.find_first_of(" \t,;"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

bool EndsFileName(std::string_view word) {
  if (!word.empty() && (word.back() == '"' || word.back() == '\'')) word.remove_suffix(1);
  return HasPictureEnding(word);
}

/// The files of a line with the number before each. A name with blanks runs on until a picture's ending.
std::vector<Column> FilesOf(std::string_view line) {
  const auto words = Words(line);
  std::vector<Column> columns;
  for (size_t i = 0; i < words.size(); ++i) {
    if (ParseDouble(words[i])) continue;
    size_t last = i;
    while (last < words.size() && !EndsFileName(words[last])) ++last;
    if (last == words.size()) last = i;
    const char* start = words[i].data();
    const std::string_view file(start, static_cast<size_t>(words[last].data() + words[last].size() - start));
    columns.push_back({i > 0 ? words[i - 1] : std::string_view(), file});
    i = last;
  }
  return columns;
}

/// Whether a name speaks of depth, in the parts of its path that differ from the other one's.
bool SpeaksOfDepth(const std::string& name, const std::string& other) {
  const auto parts = std::mismatch(name.begin(), name.end(), other.begin(), other.end());
  const size_t same = static_cast<size_t>(parts.first - name.begin());
  const size_t slash = name.rfind('/', same > 0 ? same - 1 : 0);
  const std::string rest = name.substr(slash == std::string::npos || slash > same ? 0 : slash);
  return LowerCase(rest).find("depth") != std::string::npos;
}

/// Whether the second picture is the depth of the first; nothing where neither names nor pictures tell.
std::optional<bool> IsDepthSecond(const ListedPicture& first, const ListedPicture& second) {
  const bool first_speaks = SpeaksOfDepth(first.name, second.name);
  const bool second_speaks = SpeaksOfDepth(second.name, first.name);
  if (first_speaks != second_speaks) return second_speaks;
  const auto is_depth = [](const std::string& path) {
    const int type = ReadPictureFile(path).pixels.type();
    return type == CV_16UC1 || type == CV_32FC1;
  };
  const bool first_is = is_depth(first.path), second_is = is_depth(second.path);
  if (first_is != second_is) return second_is;
  return std::nullopt;
}

bool IsHeading(const TextLine& line) {
  return std::isalpha(static_cast<unsigned char>(line.text.front())) && !HasPictureEnding(line.text);
}

}  // namespace

Result<Associations> ReadAssociations(const std::string& path) {
  const auto text = ReadTextFile(path);
  if (!text) return text.error();
  const std::string folder = fs::path(path).parent_path().string();
  Associations lists{{path, {}}, {path, {}}};
  std::optional<bool> is_depth_second;
  for (size_t i = 0; i < text->lines.size(); ++i) {
    const TextLine& line = text->lines[i];
    if (i == 0 && IsHeading(line)) continue;
    const std::string where = text->Where(line);
    const auto columns = FilesOf(line.text);
    if (columns.size() != 2) {
      return BadInput(where + ": a line names a colour and a depth picture, each behind its time stamp; here are " +
                      std::to_string(columns.size()) + " file names");
    }
    ListedPicture pictures[2];
    for (int k = 0; k < 2; ++k) {
      const auto time = ReadStamp(columns[k].stamp, where);
      if (!time) return time.error();
      pictures[k] = LocatePicture(folder, columns[k].file);
      pictures[k].time = *time;
      pictures[k].line = line.number;
    }
    if (!is_depth_second) is_depth_second = IsDepthSecond(pictures[0], pictures[1]);
    if (!is_depth_second) return BadInput(where + ": neither name nor content tells which picture is the depth");
    lists.colour.pictures.push_back(pictures[*is_depth_second ? 0 : 1]);
    lists.depth.pictures.push_back(pictures[*is_depth_second ? 1 : 0]);
  }
  if (lists.colour.pictures.empty()) return BadInput(path + " names no picture");
  return lists;
}

}  // namespace yorb

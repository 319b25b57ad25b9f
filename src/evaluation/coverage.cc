// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/coverage.h"

#include <filesystem>
#include <utility>

#include "core/text.h"
#include "evaluation/associate.h"
#include "evaluation/ate.h"

namespace yorb {
namespace {

constexpr double kMaxDifference = 0.02;  // seconds

bool Names(std::string_view path, const char* word) {
  return LowerCase(std::string(path)).find(word) != std::string::npos;
}

/// Whether associations.txt names the depth picture before the colour picture.
bool IsDepthFirst(const TextFile& file) {
  for (const TextLine& line : file.lines) {
    const auto fields = SplitAtBlanks(line.text);
    if (fields.size() < 4) continue;
    const bool first = Names(fields[1], "depth"), second = Names(fields[3], "depth");
    if (first != second) return first;
  }
  return false;
}

}  // namespace

Result<std::vector<Timestamp>> ReadColourStamps(const std::string& folder) {
  const std::filesystem::path associations = std::filesystem::path(folder) / "associations.txt";
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    return BadInput(folder + " is no folder; --sequence takes a sequence in TUM layout");
  const bool is_associated = std::filesystem::exists(associations, ignored);
  const std::string path = is_associated ? associations.string() : (std::filesystem::path(folder) / "rgb.txt").string();
  const auto file = ReadTextFile(path);
  if (!file) return file.error();
  if (file->lines.empty()) return BadInput(path + " names no pictures");
  const size_t column = is_associated && IsDepthFirst(*file) ? 2 : 0;
  std::vector<Timestamp> stamps;
  for (const TextLine& line : file->lines) {
    const auto fields = SplitAtBlanks(line.text);
    const auto stamp = fields.size() > column + 1 ? ParseTimestamp(fields[column]) : std::nullopt;
    if (!stamp) return BadInput(file->Where(line) + ": a time stamp and a picture's file name are expected");
    if (!stamps.empty() && *stamp <= stamps.back())
      return BadInput(file->Where(line) + ": the colour time stamp " + ToString(*stamp) + " goes back or repeats");
    stamps.push_back(*stamp);
  }
  return stamps;
}

double CoverageOf(const std::vector<Timestamp>& pictures, const Trajectory& estimate, double offset) {
  if (pictures.empty()) return 0;
  const size_t covered = AssociateStamps(pictures, StampsOf(estimate), kMaxDifference, offset).size();
  return static_cast<double>(covered) / static_cast<double>(pictures.size());
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/labels.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "core/iou.h"
#include "core/text.h"

namespace yorb {
namespace {

/// The numbers of a line; nothing where a field is none.
std::optional<std::vector<double>> Numbers(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string_view field : SplitAtBlanks(text)) {
    const std::optional<double> number = ParseDouble(field);
    if (!number || !(*number > -1e6 && *number < 1e6)) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// The box from its corners, cut to the picture.
LabelBox FromCorners(double left, double top, double right, double bottom) {
  left = std::clamp(left, 0.0, 1.0), right = std::clamp(right, 0.0, 1.0);
  top = std::clamp(top, 0.0, 1.0), bottom = std::clamp(bottom, 0.0, 1.0);
  return {static_cast<float>((left + right) / 2), static_cast<float>((top + bottom) / 2),
          static_cast<float>(right - left), static_cast<float>(bottom - top)};
}

struct Corners {
  double left = 0, top = 0, right = 0, bottom = 0;
};

Corners CornersOf(const LabelBox& box) {
  const double half_width = box.width / 2.0, half_height = box.height / 2.0;
  return {box.cx - half_width, box.cy - half_height, box.cx + half_width, box.cy + half_height};
}

LabelBox BoxOf(const std::vector<double>& n) {
  if (n.size() <= 6) return FromCorners(n[1] - n[3] / 2, n[2] - n[4] / 2, n[1] + n[3] / 2, n[2] + n[4] / 2);
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  for (size_t i = 1; i + 1 < n.size(); i += 2) {
    left = std::min(left, n[i]), right = std::max(right, n[i]);
    top = std::min(top, n[i + 1]), bottom = std::max(bottom, n[i + 1]);
  }
  return FromCorners(left, top, right, bottom);
}

bool IsSame(const LabelBox& a, const LabelBox& b) { return a.class_index == b.class_index && IoU(a, b) > 0.999; }

}  // namespace

Result<std::vector<LabelBox>> ReadYoloLabels(const std::string& path, int num_classes) {
  std::vector<LabelBox> boxes;
  if (!std::filesystem::exists(path)) return boxes;
  const Result<TextFile> file = ReadTextFile(path);
  if (!file) return file.error();
  for (const TextLine& line : file->lines) {
    const auto n = Numbers(line.text);
    const bool is_polygon = n && n->size() >= 7 && n->size() % 2 == 1;
    if (!n || (n->size() != 5 && !is_polygon) || (*n)[0] != static_cast<int>((*n)[0]))
      return BadInput(file->Where(line) + ": a line is `class cx cy width height` in parts of the picture, not '" +
                      OneLine(line.text) + "'");
    if ((*n)[0] < 0 || (*n)[0] >= num_classes)
      return BadInput(file->Where(line) + ": class " + std::to_string(static_cast<long long>((*n)[0])) +
                      " is not among the " + std::to_string(num_classes) + " of the list of classes");
    LabelBox box = BoxOf(*n);
    box.class_index = static_cast<int16_t>((*n)[0]);
    const bool is_new = std::none_of(boxes.begin(), boxes.end(), [&](const auto& b) { return IsSame(b, box); });
    if (box.width > 0 && box.height > 0 && is_new) boxes.push_back(box);
  }
  return boxes;
}

Result<std::vector<LabelBox>> ReadDoubtfulBoxes(const std::string& path, int num_classes, double low, double high) {
  std::vector<LabelBox> boxes;
  if (!std::filesystem::exists(path)) return boxes;
  const Result<TextFile> file = ReadTextFile(path);
  if (!file) return file.error();
  for (const TextLine& line : file->lines) {
    const auto n = Numbers(line.text);
    if (!n || n->size() != 6 || (*n)[0] < 0 || (*n)[0] >= num_classes)
      return BadInput(file->Where(line) + ": a line is `class cx cy width height confidence`, not '" +
                      OneLine(line.text) + "'");
    if ((*n)[5] < low || (*n)[5] >= high) continue;
    LabelBox box = BoxOf(*n);
    box.class_index = static_cast<int16_t>((*n)[0]);
    box.is_doubtful = 1;
    if (box.width > 0 && box.height > 0) boxes.push_back(box);
  }
  return boxes;
}

double IoU(const LabelBox& a, const LabelBox& b) { return IoU(CornersOf(a), CornersOf(b)); }

}  // namespace yorb

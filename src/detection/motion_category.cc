// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/motion_category.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/installed.h"
#include "core/text.h"
#include "detection/class_names.h"

namespace yorb {
namespace {

// Our reading of the paper's three kinds; what stands in neither list is static.
constexpr const char* kHigh[] = {"person",     "people",   "man",   "woman",       "child",    "bicycle", "car",
                                 "motorcycle", "bus",      "train", "truck",       "boat",     "bird",    "cat",
                                 "dog",        "horse",    "sheep", "cow",         "elephant", "bear",    "zebra",
                                 "giraffe",    "airplane", "robot", "robot vacuum"};
constexpr const char* kLow[] = {
    "backpack",      "umbrella",    "handbag",    "tie",          "suitcase",       "frisbee",    "skis",
    "snowboard",     "sports ball", "kite",       "baseball bat", "baseball glove", "skateboard", "surfboard",
    "tennis racket", "bottle",      "wine glass", "cup",          "fork",           "knife",      "spoon",
    "bowl",          "banana",      "apple",      "sandwich",     "orange",         "broccoli",   "carrot",
    "hot dog",       "pizza",       "donut",      "cake",         "chair",          "laptop",     "mouse",
    "remote",        "keyboard",    "cell phone", "book",         "scissors",       "teddy bear", "hair drier",
    "toothbrush",    "box",         "pillow",     "door",         "towel",          "clothes",    "bag",
    "paper"};

std::optional<Motion> ParseMotion(std::string_view word) {
  for (const Motion motion : {Motion::kStatic, Motion::kLow, Motion::kHigh}) {
    if (word == ToString(motion)) return motion;
  }
  return std::nullopt;
}

}  // namespace

std::string ToString(Motion motion) {
  return motion == Motion::kHigh ? "high" : motion == Motion::kLow ? "low" : "static";
}

MotionTable MotionTable::Default() {
  MotionTable table;
  for (const std::string& name : CocoNames()) table.Set(name, Motion::kStatic);
  for (const char* name :
       {"door", "cabinet", "desk", "table", "window", "counter", "shelves", "bookshelf", "lamp", "picture"})
    table.Set(name, Motion::kStatic);
  for (const char* name : kLow) table.Set(name, Motion::kLow);
  for (const char* name : kHigh) table.Set(name, Motion::kHigh);
  return table;
}

Motion MotionTable::Of(const std::string& name) const {
  const auto found = by_name_.find(FoldClassName(name));
  return found == by_name_.end() ? Motion::kStatic : found->second;
}

bool MotionTable::Knows(const std::string& name) const { return by_name_.count(FoldClassName(name)) > 0; }

void MotionTable::Set(const std::string& name, Motion motion) { by_name_[FoldClassName(name)] = motion; }

Result<MotionTable> ReadMotionTable(const std::string& path) {
  const auto file = ReadTextFile(path);
  if (!file) return file.error();
  MotionTable table = MotionTable::Default();
  for (const TextLine& line : file->lines) {
    std::vector<std::string_view> words = SplitAtBlanks(line.text);
    if (words.size() > 2 && ParseInteger(words.front())) words.erase(words.begin());
    const auto motion = ParseMotion(words.back());
    if (words.size() < 2 || !motion)
      return BadInput(file->Where(line) + ": a line is 'number name motion', and motion is high, low or static");
    std::string name(words.front());
    for (size_t i = 1; i + 1 < words.size(); ++i) name += " " + std::string(words[i]);
    table.Set(name, *motion);
  }
  return table;
}

Result<MotionTable> InstalledMotionTable() {
  const auto folder = InstalledFolder("models");
  const std::filesystem::path path = std::filesystem::path(folder.value_or("models")) / "classes.txt";
  std::error_code ignored;
  if (!folder || !std::filesystem::exists(path, ignored)) return MotionTable::Default();
  return ReadMotionTable(path.string());
}

}  // namespace yorb

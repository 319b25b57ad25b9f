// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labelled_set.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>
#include <utility>

#include "core/text.h"
#include "pictures/picture_folder.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr double kSlack = 0.01;  // of the picture that labels may reach beyond it, as rounding leaves them

LabelledBox FromCentre(const std::vector<double>& n) {
  return {0, n[0] - n[2] / 2, n[1] - n[3] / 2, n[0] + n[2] / 2, n[1] + n[3] / 2};
}

/// The box about a polygon's corners.
LabelledBox FromPolygon(const std::vector<double>& n) {
  LabelledBox box{0, n[0], n[1], n[0], n[1]};
  for (size_t i = 0; i + 1 < n.size(); i += 2) {
    box.left = std::min(box.left, n[i]), box.right = std::max(box.right, n[i]);
    box.top = std::min(box.top, n[i + 1]), box.bottom = std::max(box.bottom, n[i + 1]);
  }
  return box;
}

bool HasArea(const LabelledBox& box) { return box.right > box.left && box.bottom > box.top; }

/// What is wrong with the numbers behind the class, in words; empty where all is well.
std::string FaultOf(const std::vector<double>& numbers, size_t num_words) {
  const bool is_box = numbers.size() == 4, is_polygon = numbers.size() >= 6 && numbers.size() % 2 == 0;
  if (numbers.size() + 1 != num_words) return "not all of them are numbers";
  if (!is_box && !is_polygon) return "there are " + std::to_string(num_words) + " numbers";
  for (size_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i]) || numbers[i] < -kSlack || numbers[i] > 1 + kSlack)
      return "they are no fractions of the picture from 0 to 1";
  }
  if (is_box && (numbers[2] <= 0 || numbers[3] <= 0)) return "the box is empty";
  if (is_polygon && !HasArea(FromPolygon(numbers))) return "the polygon has no area";
  return "";
}

Result<LabelledBox> ParseLabel(const std::string& line, const std::vector<std::string>& classes) {
  const auto words = SplitAtBlanks(line);
  const auto label = ParseInteger(words.front());
  if (!label) return BadInput("'" + std::string(words.front()).substr(0, 40) + "' is no number of a class");
  if (*label < 0 || *label >= static_cast<long long>(classes.size()) || classes[static_cast<size_t>(*label)].empty())
    return BadInput("the list of classes has no number " + std::to_string(*label));
  std::vector<double> numbers;
  for (size_t i = 1; i < words.size(); ++i) {
    if (const auto number = ParseDouble(words[i])) numbers.push_back(*number);
  }
  const std::string fault = FaultOf(numbers, words.size());
  if (!fault.empty()) return BadInput(fault);
  LabelledBox box = numbers.size() == 4 ? FromCentre(numbers) : FromPolygon(numbers);
  box.label = static_cast<int>(*label);
  for (double* edge : {&box.left, &box.top, &box.right, &box.bottom}) *edge = std::clamp(*edge, 0.0, 1.0);
  return box;
}

std::string SetsOf(const fs::path& images) {
  std::string sets;
  std::error_code error;
  for (fs::directory_iterator entry(images, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (fs::is_directory(entry->path(), ignored))
      sets += (sets.empty() ? "" : ", ") + entry->path().filename().string();
  }
  return sets.empty() ? "" : "; there are " + sets;
}

/// Whether a label file for any picture is there: a set without one is laid out in another way.
Status CheckLayout(const LabelledSet& set, size_t num_label_files, const std::string& labels) {
  if (set.pictures.empty()) return BadInput(set.folder + " holds no pictures under images/");
  if (num_label_files > 0) return Status::Ok();
  return BadInput(labels + " holds no label file for any of the " + std::to_string(set.pictures.size()) +
                  " pictures; the labels of images/A/B.jpg stand in labels/A/B.txt");
}

}  // namespace

Result<std::vector<LabelledBox>> ReadLabelFile(const std::string& path, const std::vector<std::string>& classes) {
  const auto file = ReadTextFile(path);
  if (!file) return file.error();
  std::vector<LabelledBox> boxes;
  for (const TextLine& line : file->lines) {
    const auto box = ParseLabel(line.text, classes);
    if (!box)
      return BadInput(file->Where(line) + ": " + box.error().message +
                      "; a line is 'class x y width height', fractions of the picture");
    const auto key = [](const LabelledBox& b) { return std::tie(b.label, b.left, b.top, b.right, b.bottom); };
    const bool is_known =
        std::any_of(boxes.begin(), boxes.end(), [&](const LabelledBox& known) { return key(known) == key(*box); });
    if (!is_known) boxes.push_back(*box);
  }
  return boxes;
}

Result<LabelledSet> ReadLabelledSet(const std::string& folder, const std::string& set) {
  std::error_code ignored;
  const fs::path images = fs::path(folder) / "images", labels = fs::path(folder) / "labels";
  if (!fs::is_directory(folder, ignored))
    return BadInput(folder + (fs::exists(folder, ignored) ? " is no folder" : " does not exist"));
  if (!fs::is_directory(images, ignored))
    return BadInput(
        folder + " has no folder images; pictures lie under images/ and their labels at the same place under labels/");
  if (!fs::is_directory(images / set, ignored))
    return BadInput((images / set).string() + " is no folder" + SetsOf(images));
  auto classes = ReadClassList(folder);
  if (!classes) return classes.error();
  LabelledSet result{folder, *std::move(classes), {}};
  size_t num_label_files = 0;
  for (const std::string& picture : PicturesUnder((set.empty() ? images : images / set).string())) {
    const fs::path place = fs::path(picture).lexically_relative(images).replace_extension(".txt");
    const std::string label_file = (labels / place).string();
    LabelledPicture entry{picture, {}};
    if (fs::exists(label_file, ignored)) {
      auto boxes = ReadLabelFile(label_file, result.classes);
      if (!boxes) return boxes.error();
      entry.boxes = *std::move(boxes);
      ++num_label_files;
    }
    result.pictures.push_back(std::move(entry));
  }
  if (Status layout = CheckLayout(result, num_label_files, labels.string()); !layout) return layout.error();
  return result;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labelled_set.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "core/log.h"
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
std::string FaultOf(const std::vector<double>& numbers) {
  const bool is_box = numbers.size() == 4, is_polygon = numbers.size() >= 6 && numbers.size() % 2 == 0;
  if (!is_box && !is_polygon) return "there are " + std::to_string(numbers.size() + 1) + " numbers";
  for (size_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i]) || numbers[i] < -kSlack || numbers[i] > 1 + kSlack)
      return "they are no fractions of the picture from 0 to 1";
  }
  if (is_box && (numbers[2] <= 0 || numbers[3] <= 0)) return "the box is empty";
  if (is_polygon && !HasArea(FromPolygon(numbers))) return "the polygon has no area";
  return "";
}

/// The number of a class; numpy's savetxt writes it as 0.000000e+00.
std::optional<long long> ParseClass(std::string_view word) {
  if (const auto number = ParseInteger(word)) return number;
  const auto number = ParseDouble(word);
  return number ? WholeNumber(*number) : std::nullopt;
}

Result<LabelledBox> ParseLabel(const std::string& line, const LabelForm& form) {
  const auto& classes = form.classes;
  const auto words = SplitAtBlanks(line);
  const auto label = ParseClass(words.front());
  if (!label) return BadInput("'" + std::string(words.front()).substr(0, 40) + "' is no number of a class");
  if (*label < 0 || *label >= static_cast<long long>(classes.size()) || classes[static_cast<size_t>(*label)].empty())
    return BadInput("the list of classes has no number " + std::to_string(*label));
  std::vector<double> numbers;
  for (size_t i = 1; i < words.size(); ++i) {
    if (const auto number = ParseDouble(words[i])) numbers.push_back(*number);
  }
  if (numbers.size() + 1 != words.size()) return BadInput("not all of them are numbers");
  if (form.num_keypoint_numbers > 0 && numbers.size() == 4 + form.num_keypoint_numbers) numbers.resize(4);
  if (const std::string fault = FaultOf(numbers); !fault.empty()) return BadInput(fault);
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

/// The first file with an ending in a folder; empty where there is none.
std::string FileIn(const fs::path& folder, const char* ending) {
  std::string first;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const fs::path& path = entry->path();
    const bool is_list = path.filename() == "classes.txt";
    if (LowerCase(path.extension().string()) == ending && !is_list && (first.empty() || path.string() < first))
      first = path.string();
  }
  return first;
}

/// What labels of other tools are there, and what may be done; empty where none are seen.
std::string OtherLabels(const fs::path& folder, const fs::path& labels, const fs::path& images) {
  for (const fs::path& place : {labels, folder / "annotations", folder / "Annotations", images, folder}) {
    if (const std::string file = FileIn(place, ".xml"); !file.empty())
      return "; " + file + " is one of Pascal VOC's form, which is not read: convert them to YOLO's";
    if (const std::string file = FileIn(place, ".json"); !file.empty())
      return "; " + file + " may be of COCO's form, which is not read: convert it to YOLO's";
  }
  const std::string beside = FileIn(images, ".txt");
  return beside.empty() ? "" : "; " + beside + " lies among the pictures: move such files into " + labels.string();
}

/// Whether a label file for any picture is there: a set without one is laid out in another way.
Status CheckLayout(const LabelledSet& set, size_t num_label_files, const std::string& labels) {
  if (set.pictures.empty()) return BadInput(set.folder + " holds no pictures under images/");
  if (num_label_files > 0) return Status::Ok();
  return BadInput(labels + " holds no label file for any of the " + std::to_string(set.pictures.size()) +
                  " pictures; the labels of images/A/B.jpg stand in labels/A/B.txt" +
                  OtherLabels(set.folder, labels, fs::path(set.pictures.front().picture).parent_path()));
}

/// The complaint about a folder without images/: sets in folders of their own, as Roboflow's are, are named.
Error NoImages(const std::string& folder) {
  std::set<std::string> sets;
  std::error_code error, ignored;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (fs::is_directory(entry->path() / "images", ignored)) sets.insert(entry->path().string());
  }
  if (!sets.empty()) {
    return BadInput(folder + " has no folder images, but " + *sets.begin() + " has one; name that, --evaluate " +
                    *sets.begin());
  }
  return BadInput(folder +
                  " has no folder images; pictures lie under images/ and their labels at the same place under labels/" +
                  OtherLabels(folder, fs::path(folder) / "labels", folder));
}

/// Label files that no picture took: of 0.png.txt and 0.TXT the picture would count as empty, without a word.
void WarnOfLabelsWithoutPicture(const std::string& labels, const std::set<std::string>& taken) {
  std::set<std::string> left;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(labels, error), end; !error && entry != end; entry.increment(error)) {
    const fs::path path = entry->path();
    const bool is_hidden = path.filename().string().front() == '.', is_list = path.filename() == "classes.txt";
    const bool is_label = LowerCase(path.extension().string()) == ".txt" && !is_hidden && !is_list;
    if (is_label && taken.count(path.string()) == 0) left.insert(path.string());
  }
  if (left.empty()) return;
  LogWarning("labels-without-picture",
             std::to_string(left.size()) + (left.size() == 1 ? " label file belongs" : " label files belong") +
                 " to no picture and " + (left.size() == 1 ? "is" : "are") + " left out, first " + *left.begin() +
                 "; the labels of images/A/B.jpg stand in labels/A/B.txt");
}

}  // namespace

Result<std::vector<LabelledBox>> ReadLabelFile(const std::string& path, const LabelForm& form) {
  const auto file = ReadTextFile(path);
  if (!file) return file.error();
  std::vector<LabelledBox> boxes;
  for (const TextLine& line : file->lines) {
    const auto box = ParseLabel(line.text, form);
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
  if (!fs::is_directory(images, ignored)) return NoImages(folder);
  if (!fs::is_directory(images / set, ignored))
    return BadInput((images / set).string() + " is no folder" + SetsOf(images));
  const auto form = ReadLabelForm(folder, set);
  if (!form) return form.error();
  LabelledSet result{folder, form->classes, {}};
  std::set<std::string> label_files;
  for (const std::string& picture : PicturesUnder((set.empty() ? images : images / set).string())) {
    const fs::path place = fs::path(picture).lexically_relative(images).replace_extension(".txt");
    const std::string label_file = (labels / place).string();
    LabelledPicture entry{picture, {}};
    if (fs::exists(label_file, ignored)) {
      auto boxes = ReadLabelFile(label_file, *form);
      if (!boxes) return boxes.error();
      entry.boxes = *std::move(boxes);
      label_files.insert(label_file);
    }
    result.pictures.push_back(std::move(entry));
  }
  if (Status layout = CheckLayout(result, label_files.size(), labels.string()); !layout) return layout.error();
  WarnOfLabelsWithoutPicture((set.empty() ? labels : labels / set).string(), label_files);
  return result;
}

}  // namespace yorb

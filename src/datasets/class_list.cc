// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The lists of classes that sets of labelled pictures carry.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/log.h"
#include "core/text.h"
#include "datasets/labelled_set.h"
#include "detection/class_names.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

Error BadYaml(const std::string& path, const YAML::Mark& mark, const std::string& fault) {
  return BadInput(path + (mark.is_null() ? "" : ", line " + std::to_string(mark.line + 1)) + ": " + fault);
}

/// `names` of a data.yaml: a list, or names by number.
Result<Names> NamesOf(const YAML::Node& list, const std::string& path) {
  if (!list.IsSequence() && !list.IsMap())
    return BadYaml(path, list.Mark(), "names is no list; write names: [person, chair], or a line each");
  Names names;
  long long next = 0;
  for (const auto& entry : list) {
    const YAML::Node name = list.IsMap() ? entry.second : entry;
    if (!name.IsScalar()) return BadYaml(path, name.Mark(), "the name of a class must be a word");
    const auto number = list.IsMap() ? ParseInteger(entry.first.IsScalar() ? entry.first.Scalar() : "") : next++;
    if (!number) return BadYaml(path, name.Mark(), "a name of names has no number before it");
    if (*number < 0 || *number >= kMostListedClasses)
      return BadYaml(path, name.Mark(), "the number of a class is out of range");
    const auto index = static_cast<size_t>(*number);
    if (names.size() <= index) names.resize(index + 1);
    if (!names[index].empty())
      return BadYaml(path, name.Mark(), "the number " + std::to_string(index) + " stands here twice");
    names[index] = name.Scalar();
  }
  if (names.empty()) return BadYaml(path, list.Mark(), "no class names follow");
  return names;
}

/// The numbers that follow a box: so many points, x and y, or with whether they are visible.
Result<size_t> KeypointNumbersOf(const YAML::Node& shape, const std::string& path) {
  const auto number_at = [&](size_t i) {
    return shape.IsSequence() && shape.size() == 2 && shape[i].IsScalar() ? ParseInteger(shape[i].Scalar())
                                                                          : std::nullopt;
  };
  const auto points = number_at(0), numbers = number_at(1);
  if (!points || !numbers || *points < 1 || *points > kMostListedClasses || *numbers < 2 || *numbers > 3)
    return BadYaml(path, shape.Mark(), "kpt_shape must be [points, 2] or [points, 3]");
  return static_cast<size_t>(*points * *numbers);
}

/// Of a data.yaml only `names` and `kpt_shape` count; its paths are those of whoever trained.
Result<LabelForm> ReadDataYaml(const std::string& path) {
  const auto text = ReadWholeText(path);
  if (!text) return text.error();
  try {
    const YAML::Node file = YAML::Load(*text);
    if (!file.IsMap() || !file["names"]) return BadInput(path + " has no names: the list of its classes");
    auto names = NamesOf(file["names"], path);
    if (!names) return names.error();
    LabelForm form{*std::move(names), 0};
    if (!file["kpt_shape"]) return form;
    const auto numbers = KeypointNumbersOf(file["kpt_shape"], path);
    if (!numbers) return numbers.error();
    form.num_keypoint_numbers = *numbers;
    return form;
  } catch (const YAML::Exception& error) {
    return BadYaml(path, error.mark, "no valid YAML: " + error.msg);
  }
}

Result<LabelForm> FormOfList(const std::string& path) {
  auto names = ReadClassList(path);
  if (!names) return names.error();
  return LabelForm{*std::move(names), 0};
}

/// Whether a YAML file has a list of names; those of settings have none.
bool HasNames(const fs::path& path) {
  const auto text = ReadWholeText(path.string());
  if (!text) return false;
  try {
    const YAML::Node file = YAML::Load(*text);
    return file.IsMap() && file["names"];
  } catch (const YAML::Exception&) {
    return false;
  }
}

/// Lists of classes under names of their own: coco128.yaml, obj.names.
std::vector<fs::path> OtherListsIn(const fs::path& folder) {
  std::vector<fs::path> lists;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    const std::string ending = LowerCase(entry->path().extension().string());
    const bool is_yaml = ending == ".yaml" || ending == ".yml", is_file = fs::is_regular_file(entry->path(), ignored);
    if (is_file && (ending == ".names" || (is_yaml && HasNames(entry->path())))) lists.push_back(entry->path());
  }
  std::sort(lists.begin(), lists.end());
  return lists;
}

/// The folder that a folder lies in.
fs::path Above(const std::string& folder) {
  std::error_code error;
  const fs::path place = fs::canonical(folder, error);
  return error ? fs::path() : place.parent_path();
}

}  // namespace

Result<LabelForm> ReadLabelForm(const std::string& folder, const std::string& set) {
  const fs::path place = folder;
  const auto is_there = [](const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
  };
  if (const fs::path list = place / "classes.txt"; is_there(list)) return FormOfList(list.string());
  for (const char* name : {"data.yaml", "data.yml"}) {
    if (is_there(place / name)) return ReadDataYaml((place / name).string());
  }
  // LabelImg writes its list among the labels.
  for (const fs::path& list : {place / "labels" / "classes.txt", place / "labels" / set / "classes.txt"}) {
    if (is_there(list)) return FormOfList(list.string());
  }
  // Roboflow's sets, DIR/valid and DIR/test, share the file above them.
  if (const fs::path list = Above(folder) / "data.yaml"; is_there(list)) return ReadDataYaml(list.string());
  const std::vector<fs::path> others = OtherListsIn(place);
  if (others.size() > 1)
    return BadInput(folder + " has several lists of classes, " + others[0].filename().string() + " and " +
                    others[1].filename().string() + "; name the right one data.yaml, or classes.txt");
  if (others.size() == 1)
    return LowerCase(others[0].extension().string()) == ".names" ? FormOfList(others[0].string())
                                                                 : ReadDataYaml(others[0].string());
  LogWarning("no-class-list",
             folder + " has no list of its classes (classes.txt or data.yaml); they count as COCO's 80");
  return LabelForm{CocoNames(), 0};
}

}  // namespace yorb

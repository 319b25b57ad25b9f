// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_scenes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "training/class_table.h"
#include "training/picture_set.h"
#include "training/read_picture.h"
#include "training/scene.h"

namespace yorb {
namespace {

constexpr int kSceneLongSidePx = 640;
constexpr double kMarginPx = 3;  // around boxes, which are often drawn a little too tight

/// Sorts a scene in by what is known of its people.
void Sort(PlainScene scene, PlainScenes& scenes) {
  const auto is_sure = [](const LabelBox& box) { return box.is_doubtful == 0; };
  if (scene.people.empty())
    scenes.empty.push_back(std::move(scene));
  else if (std::any_of(scene.people.begin(), scene.people.end(), is_sure))
    scenes.peopled.push_back(std::move(scene));
}

std::vector<LabelBox> OnlyClass(std::vector<LabelBox> boxes, int class_index) {
  std::erase_if(boxes, [&](const LabelBox& box) { return box.class_index != class_index; });
  return boxes;
}

Error NoPerson(const std::string& path) {
  return BadInput(path + ": its classes have no person, and only pictures that are labelled for people can say where " +
                  "nobody is");
}

Status AddPack(const std::string& path, PlainScenes& scenes) {
  const auto pack = Pack::Open(path);
  if (!pack) return pack.error();
  const auto person = ClassTable{(*pack)->class_names(), {}}.Find("person");
  if (!person) return NoPerson(path);
  for (size_t i = 0; i < (*pack)->size(); ++i) {
    const PackedPicture picture = (*pack)->Get(i);
    if (picture.judged[static_cast<size_t>(*person)]) Sort({*pack, i, "", OnlyClass(picture.boxes, *person)}, scenes);
  }
  return Status::Ok();
}

Status AddFolder(const std::string& folder, PlainScenes& scenes) {
  const auto files = FindLabelledFiles(folder);
  if (!files) return files.error();
  const auto list = FindClassList(folder);
  if (!list) return list.error();
  const auto classes = ReadClassTable(*list);
  if (!classes) return classes.error();
  const auto person = classes->Find("person");
  if (!person) return NoPerson(*list);
  for (const LabelledFile& file : *files) {
    auto boxes = ReadYoloLabels(file.labels, classes->size());
    if (!boxes) return boxes.error();
    const std::string teacher = FileBeside(file.picture, "labels_teacher", ".txt").value_or("");
    if (!teacher.empty()) {
      const auto more = ReadDoubtfulBoxes(teacher, classes->size(), 0, HUGE_VAL);
      if (!more) return more.error();
      boxes->insert(boxes->end(), more->begin(), more->end());
    }
    Sort({nullptr, 0, file.picture, OnlyClass(*boxes, *person)}, scenes);
  }
  return Status::Ok();
}

/// Nobody anywhere but in the boxes.
cv::Mat MaskOf(const std::vector<LabelBox>& people, const cv::Size& size) {
  cv::Mat mask(size, CV_8U, cv::Scalar(kMaskNobody));
  for (const LabelBox& box : people) {
    const auto edge = [](double middle, double half, int length) {
      return static_cast<int>(std::lround(std::clamp((middle + half) * length, 0.0, 1.0 * length)));
    };
    const double half_width = box.width / 2 + kMarginPx / size.width;
    const double half_height = box.height / 2 + kMarginPx / size.height;
    const cv::Rect area(cv::Point(edge(box.cx, -half_width, size.width), edge(box.cy, -half_height, size.height)),
                        cv::Point(edge(box.cx, half_width, size.width), edge(box.cy, half_height, size.height)));
    mask(area).setTo(kMaskUnknown);
  }
  return mask;
}

}  // namespace

Result<PlainScenes> FindPlainScenes(const std::vector<std::string>& paths) {
  PlainScenes scenes;
  for (const std::string& path : paths) {
    const bool is_folder = std::filesystem::is_directory(path);
    if (const Status added = is_folder ? AddFolder(path, scenes) : AddPack(path, scenes); !added) return added.error();
  }
  return scenes;
}

Result<MaskedPicture> ReadPlainScene(const PlainScene& scene) {
  if (scene.pack) {
    const cv::Mat pixels = scene.pack->Get(scene.index).pixels;
    return MaskedPicture{pixels, MaskOf(scene.people, pixels.size())};
  }
  const Result<cv::Mat> pixels = ReadSmallPicture(scene.file, kSceneLongSidePx);
  if (!pixels) return pixels.error();
  return MaskedPicture{*pixels, MaskOf(scene.people, pixels->size())};
}

}  // namespace yorb

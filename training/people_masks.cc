// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/people_masks.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "pictures/picture_file.h"
#include "training/read_picture.h"
#include "training/scene.h"

namespace yorb {
namespace {

constexpr int kLongSidePx = 640;           // no detail finer than that reaches the network
constexpr int kLeastCutoutPx = 1500;       // area: smaller ones are blurs when enlarged
constexpr double kLeastPart = 0.02;        // of a picture that people fill: others show them too small
constexpr double kMostUnknownPart = 0.02;  // of the box around a cut-out

cv::Mat ThreeValues(const cv::Mat& stored) {
  constexpr int kFromUnknown = (kMaskNobody + kMaskUnknown) / 2, kFromPerson = (kMaskUnknown + kMaskPerson) / 2;
  cv::Mat mask(stored.size(), CV_8U, cv::Scalar(kMaskNobody));
  mask.setTo(kMaskUnknown, stored > kFromUnknown);
  mask.setTo(kMaskPerson, stored > kFromPerson);
  return mask;
}

void CutOut(const MaskedPicture& picture, std::vector<cv::Mat>& cutouts) {
  const cv::Mat person = picture.people_mask == kMaskPerson;
  if (cv::countNonZero(person) < kLeastPart * static_cast<double>(person.total())) return;
  cv::Mat parts, boxes, centres;
  const int num_parts = cv::connectedComponentsWithStats(person, parts, boxes, centres);
  for (int part = 1; part < num_parts; ++part) {
    const int* const box = boxes.ptr<int>(part);
    if (box[cv::CC_STAT_AREA] < kLeastCutoutPx) continue;
    const cv::Rect around(box[cv::CC_STAT_LEFT], box[cv::CC_STAT_TOP], box[cv::CC_STAT_WIDTH], box[cv::CC_STAT_HEIGHT]);
    const int num_unknown = cv::countNonZero(picture.people_mask(around) == kMaskUnknown);
    if (num_unknown > kMostUnknownPart * around.area()) continue;
    cv::Mat alpha = parts(around) == part, cutout;
    cv::GaussianBlur(alpha, alpha, cv::Size(), 0.7);
    cv::merge(std::vector<cv::Mat>{picture.pixels(around), alpha}, cutout);
    cutouts.push_back(cutout);
  }
}

}  // namespace

Result<std::vector<LabelledFile>> FindMaskedFiles(const std::string& folder) {
  auto files = FindLabelledFiles(folder + "/images");
  if (!files) return files.error();
  for (LabelledFile& file : *files) {
    file.labels = FileBeside(file.picture, "masks", ".png").value_or("");
    if (!std::filesystem::exists(file.labels))
      return BadInput(file.picture + ": has no mask; " + file.labels +
                      " is to be 255 where people are, 0 where nobody " + "is, and 128 where that is unknown");
  }
  return files;
}

Result<MaskedPicture> ReadMaskedPicture(const LabelledFile& file) {
  const Result<cv::Mat> pixels = ReadSmallPicture(file.picture, kLongSidePx);
  if (!pixels) return pixels.error();
  const StoredPicture stored = ReadPictureFile(file.labels);
  if (stored.pixels.empty()) return BadInput(file.labels + ": " + stored.fault);
  if (stored.pixels.type() != CV_8UC1)
    return BadInput(file.labels + ": is no grey picture of 8 bits, as masks of people are");
  MaskedPicture picture{*pixels, ThreeValues(stored.pixels)};
  cv::resize(picture.people_mask, picture.people_mask, pixels->size(), 0, 0, cv::INTER_NEAREST);
  return picture;
}

Result<std::vector<cv::Mat>> CutOutPeople(const std::vector<LabelledFile>& files) {
  std::vector<cv::Mat> cutouts;
  for (const LabelledFile& file : files) {
    const Result<MaskedPicture> picture = ReadMaskedPicture(file);
    if (!picture) return picture.error();
    CutOut(*picture, cutouts);
  }
  return cutouts;
}

SetsOfPictures::SetsOfPictures(const std::vector<LabelledFile>& files) {
  std::map<std::string, std::vector<LabelledFile>> by_name;
  for (const LabelledFile& file : files) by_name[file.name.substr(0, file.name.find('_'))].push_back(file);
  for (auto& [name, set] : by_name) {
    total_weight_ += std::sqrt(static_cast<double>(set.size()));
    sets_.push_back(std::move(set));
  }
}

const LabelledFile& SetsOfPictures::Draw(double set, double within) const {
  YORB_CHECK(!sets_.empty(), "pictures are drawn where there are some");
  double left = set * total_weight_;
  size_t i = 0;
  for (; i + 1 < sets_.size(); ++i) {
    const double weight = std::sqrt(static_cast<double>(sets_[i].size()));
    if (left < weight) break;
    left -= weight;
  }
  const auto index = static_cast<size_t>(within * static_cast<double>(sets_[i].size()));
  return sets_[i][std::min(index, sets_[i].size() - 1)];
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/overlay.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "core/files.h"
#include "core/text.h"
#include "pictures/picture_file.h"
#include "pictures/picture_folder.h"
#include "runs/draw_boxes.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kColumns = "timestamp,x,y,level,verdict";

const cv::Scalar kGreen(80, 200, 60), kRed(60, 60, 230), kYellow(40, 210, 240);  // BGR

/// Tints the pixels of a mask, which may be smaller than the picture.
void Tint(cv::Mat& picture, const cv::Mat& mask, const cv::Scalar& colour) {
  if (mask.empty()) return;
  cv::Mat whole;
  cv::resize(mask, whole, picture.size(), 0, 0, cv::INTER_NEAREST);
  cv::Mat tinted;
  cv::addWeighted(picture, 0.6, cv::Mat(picture.size(), picture.type(), colour), 0.4, 0, tinted);
  tinted.copyTo(picture, whole);
}

const cv::Scalar& ColourOf(Verdict verdict) {
  if (verdict == Verdict::kDynamic) return kRed;
  return verdict == Verdict::kGivenBack ? kYellow : kGreen;
}

fs::path PointsIn(const fs::path& folder) { return folder / "points.csv"; }

fs::path PictureIn(const fs::path& folder, Timestamp time) { return folder / (ToString(time) + ".png"); }

/// What a folder holds that no overlay has written, in words: points of something else, or pictures without points.
std::string WhatElseIsIn(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(PointsIn(folder), ignored)) return PicturesIn(folder.string()).empty() ? "" : "pictures";
  std::string first;
  std::ifstream points(PointsIn(folder));
  std::getline(points, first);
  return first.empty() || first == kColumns ? "" : "a points.csv of something else";
}

/// Takes away the pictures that an older overlay has points of: two runs in one folder would look like one.
void RemovePictures(const fs::path& folder) {
  std::ifstream rows(PointsIn(folder));
  std::optional<Timestamp> last;
  for (std::string row; std::getline(rows, row);) {
    const auto time = ParseTimestamp(row.substr(0, row.find(',')));
    if (!time || time == last) continue;
    std::error_code ignored;
    fs::remove(PictureIn(folder, *time), ignored);
    last = time;
  }
}

}  // namespace

cv::Mat DrawJudgement(const Watched& watched) {
  const ImageSet& images = watched.images;
  cv::Mat picture = DrawBoxes(images.colour.empty() ? images.grey : images.colour, watched.areas.boxes());
  Tint(picture, watched.areas.bodies(), kRed);
  Tint(picture, images.ignored, kRed);
  for (size_t i = 0; i < watched.points.size(); ++i) {
    const Keypoint& point = watched.points[i];
    const cv::Point centre(static_cast<int>(std::lround(point.x)), static_cast<int>(std::lround(point.y)));
    cv::circle(picture, centre, 2, ColourOf(watched.verdicts[i]), cv::FILLED, cv::LINE_AA);
  }
  return picture;
}

Result<std::shared_ptr<OverlayWriter>> OverlayWriter::Open(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return BadInput("--save-overlay: " + folder + " cannot be made: " + error.message());
  if (const std::string what = WhatElseIsIn(folder); !what.empty())
    return BadInput("--save-overlay: " + folder + " holds " + what + " already; name another folder");
  const fs::path points = PointsIn(folder);
  const bool was_there = fs::exists(points, error);
  if (!std::ofstream(points, std::ios::app)) {
    return BadInput("--save-overlay: " + points.string() + " cannot be written");
  }
  if (!was_there) fs::remove(points, error);
  return std::shared_ptr<OverlayWriter>(new OverlayWriter(folder));
}

Status OverlayWriter::Begin() {
  RemovePictures(folder_);
  points_.open(PointsIn(folder_));
  points_ << kColumns << '\n';
  return points_.flush() ? Status::Ok() : Status(Failure(PointsIn(folder_).string() + " cannot be written"));
}

void OverlayWriter::Write(const Watched& watched) {
  const std::string time = ToString(watched.images.timestamp);
  for (size_t i = 0; i < watched.points.size(); ++i) {
    const Keypoint& point = watched.points[i];
    points_ << time << ',' << FormatFixed(static_cast<double>(point.x), 2) << ','
            << FormatFixed(static_cast<double>(point.y), 2) << ',' << point.octave << ','
            << ToString(watched.verdicts[i]) << '\n';
  }
  const std::string file = PictureIn(folder_, watched.images.timestamp).string();
  if (!status_) return;
  const auto bytes = EncodePictureFor(file, DrawJudgement(watched));
  status_ = bytes ? WriteFileQuickly(file, *bytes) : Status(bytes.error());
  if (status_ && !points_.flush()) status_ = Failure(folder_ + "/points.csv cannot be written; is the disk full?");
}

}  // namespace yorb

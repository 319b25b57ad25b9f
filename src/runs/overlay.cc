// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/overlay.h"

#include <cmath>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "core/files.h"
#include "core/text.h"
#include "pictures/picture_file.h"
#include "runs/draw_boxes.h"

namespace yorb {
namespace {

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

/// Whether a folder holds pictures that no overlay has written: there are no points of them.
bool HoldsOtherPictures(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (std::filesystem::exists(folder / "points.csv", ignored)) return false;
  const auto is_picture = [](const auto& entry) { return entry.path().extension() == ".png"; };
  const std::filesystem::directory_iterator entries(folder, ignored);
  return std::any_of(begin(entries), end(entries), is_picture);
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

OverlayWriter::OverlayWriter(std::string folder)
    : folder_(std::move(folder)), points_(std::filesystem::path(folder_) / "points.csv") {
  points_ << "timestamp,x,y,level,verdict\n";
}

Result<std::shared_ptr<OverlayWriter>> OverlayWriter::Open(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return BadInput("--save-overlay: " + folder + " cannot be made: " + error.message());
  if (HoldsOtherPictures(folder))
    return BadInput("--save-overlay: " + folder + " holds pictures already; name another folder");
  std::shared_ptr<OverlayWriter> writer(new OverlayWriter(folder));
  if (!writer->points_.flush()) return BadInput("--save-overlay: " + folder + "/points.csv cannot be written");
  return writer;
}

void OverlayWriter::Write(const Watched& watched) {
  const std::string time = ToString(watched.images.timestamp);
  for (size_t i = 0; i < watched.points.size(); ++i) {
    const Keypoint& point = watched.points[i];
    points_ << time << ',' << FormatFixed(static_cast<double>(point.x), 2) << ','
            << FormatFixed(static_cast<double>(point.y), 2) << ',' << point.octave << ','
            << ToString(watched.verdicts[i]) << '\n';
  }
  const std::string file = (std::filesystem::path(folder_) / (time + ".png")).string();
  if (!status_) return;
  const auto bytes = EncodePictureFor(file, DrawJudgement(watched));
  status_ = bytes ? WriteFileQuickly(file, *bytes) : Status(bytes.error());
  if (status_ && !points_.flush()) status_ = Failure(folder_ + "/points.csv cannot be written; is the disk full?");
}

}  // namespace yorb

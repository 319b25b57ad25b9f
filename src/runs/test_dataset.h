// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <opencv2/imgproc.hpp>
#include <set>
#include <string>
#include <utility>

#include "core/random.h"
#include "datasets/dataset.h"

namespace yorb {

/// For tests: a camera that slides along a flat, textured wall two metres away, by 6 mm a frame; made in memory.
class WallDataset : public Dataset {
 public:
  explicit WallDataset(size_t count, double rate_hz = 30) : count_(count), rate_hz_(rate_hz), wall_(MakeWall()) {
    rig_.name = "wall";
    rig_.camera.width = kWidth;
    rig_.camera.height = kHeight;
    rig_.camera.fx = rig_.camera.fy = kFocalPx;
    rig_.camera.cx = kWidth / 2.0;
    rig_.camera.cy = kHeight / 2.0;
    rig_.baseline_px = 20;
    rig_.depth_factor = 1000;
  }

  size_t size() const override { return count_; }
  Timestamp TimeOf(size_t i) const override {
    return {static_cast<int64_t>(1e9 * (100 + static_cast<double>(i) / rate_hz_))};
  }
  std::string PictureName(size_t i) const override { return "wall/" + std::to_string(i); }
  const Rig& rig() const override { return rig_; }

  Result<LoadedFrame> Load(size_t i) const override {
    LoadedFrame frame;
    if (broken.count(i) > 0) return BadInput(PictureName(i) + " is broken");
    if (unreadable.count(i) > 0) {
      frame.num_skipped = 1;
      return frame;
    }
    const int columns = i >= narrow_from ? kWidth / 2 : kWidth;
    ImageSet images;
    images.timestamp = TimeOf(i);
    images.grey = wall_(cv::Rect(static_cast<int>(i % 200), 0, columns, kHeight)).clone();
    images.depth.pixels = cv::Mat(kHeight, columns, CV_16UC1, cv::Scalar(2000));
    images.depth.pixels.colRange(0, columns / 2).setTo(left_mm);
    images.depth.metres_per_unit = 0.001;
    frame.images = std::move(images);
    frame.depth = {true, false, 1, 2};
    frame.orientation = orientation;
    return frame;
  }

  std::set<size_t> broken, unreadable;  ///< frames that cannot be read: an error, or skipped
  size_t narrow_from = size_t(-1);      ///< from here on the pictures have half the width
  int orientation = 1;                  ///< of EXIF
  int left_mm = 2000;  ///< how far away the left half of each picture is; less: it stands before the wall

 private:
  static constexpr int kWidth = 320, kHeight = 240;
  static constexpr double kFocalPx = 333;  // one pixel at two metres is 6 mm

  static cv::Mat MakeWall() {
    Random random(7);
    cv::Mat wall(kHeight, kWidth + 200, CV_8UC1, cv::Scalar(128));
    for (int i = 0; i < 1500; ++i) {
      const cv::Point corner(static_cast<int>(random.Below(kWidth + 200)), static_cast<int>(random.Below(kHeight)));
      const cv::Size size(4 + static_cast<int>(random.Below(14)), 4 + static_cast<int>(random.Below(14)));
      cv::rectangle(wall, cv::Rect(corner, size), cv::Scalar(random.Below(256)), cv::FILLED);
    }
    return wall;
  }

  size_t count_;
  double rate_hz_;
  cv::Mat wall_;
  Rig rig_;
};

}  // namespace yorb

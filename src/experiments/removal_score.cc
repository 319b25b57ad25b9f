// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/removal_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/core.hpp>

#include "datasets/masked_dataset.h"

namespace yorb {
namespace {

/// The pictures of a recording without what they show: their masks are wanted alone.
class BlankPictures : public Dataset {
 public:
  explicit BlankPictures(const Dataset& source) : source_(source) {
    blank_ = cv::Mat(rig().camera.height, rig().camera.width, CV_8UC1, cv::Scalar(0));
  }
  size_t size() const override { return source_.size(); }
  Timestamp TimeOf(size_t i) const override { return source_.TimeOf(i); }
  std::string PictureName(size_t i) const override { return source_.PictureName(i); }
  const Rig& rig() const override { return source_.rig(); }
  Result<LoadedFrame> Load(size_t i) const override {
    LoadedFrame frame;
    frame.images = ImageSet{TimeOf(i), blank_, {}, {}, {}};
    return frame;
  }

 private:
  const Dataset& source_;
  cv::Mat blank_;
};

void Count(const JudgedPoints::Picture& picture, const cv::Mat& mask, RemovalScore& score) {
  for (const JudgedPoints::Point& point : picture.points) {
    const int x = std::clamp(static_cast<int>(std::lround(point.x)), 0, mask.cols - 1);
    const int y = std::clamp(static_cast<int>(std::lround(point.y)), 0, mask.rows - 1);
    const bool moves = mask.at<uint8_t>(y, x) != 0;
    if (point.is_removed) {
      ++(moves ? score.num_removed_rightly : score.num_removed_wrongly);
    } else {
      ++(moves ? score.num_kept_wrongly : score.num_kept_rightly);
    }
  }
}

double Share(size_t part, size_t other) {
  if (part + other == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(part + other);
}

}  // namespace

void JudgedPoints::Add(const Watched& watched) {
  Picture picture{watched.images.timestamp, {}};
  picture.points.reserve(watched.points.size());
  for (size_t i = 0; i < watched.points.size(); ++i) {
    picture.points.push_back({watched.points[i].x, watched.points[i].y, watched.verdicts[i] == Verdict::kDynamic});
  }
  pictures_.push_back(std::move(picture));
}

double RemovalScore::Precision() const { return Share(num_removed_rightly, num_removed_wrongly); }
double RemovalScore::Recall() const { return Share(num_removed_rightly, num_kept_wrongly); }

Result<RemovalScore> ScoreRemoval(const JudgedPoints& judged, const Dataset& dataset, const std::string& masks) {
  const BlankPictures blank(dataset);
  const auto masked = MaskedDataset::Open(blank, masks);
  if (!masked) return masked.error();
  std::map<Timestamp, size_t> row_of;
  for (size_t i = 0; i < dataset.size(); ++i) row_of[dataset.TimeOf(i)] = i;
  RemovalScore score;
  for (const JudgedPoints::Picture& picture : judged.pictures()) {
    const auto row = row_of.find(picture.time);
    if (row == row_of.end()) continue;
    const auto frame = (*masked)->Load(row->second);
    if (!frame) return frame.error();
    if (!frame->images->ignored.empty()) Count(picture, frame->images->ignored, score);
  }
  return score;
}

}  // namespace yorb

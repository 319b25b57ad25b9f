// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/features.h"

#include <utility>

#include "experiments/features_spread.h"
#include "experiments/one_thread.h"

namespace yorb {
namespace {

constexpr int kRounds = 3;             // each picture is timed so often, the fastest counts
constexpr size_t kPaperPictures = 10;  // Table 4 of the paper: ten consecutive pairs
constexpr size_t kFarGap = 10;         // frames between the pictures of a wide pair

std::string PictureNameOf(const PictureSet& set, size_t i) {
  return set.dataset ? set.dataset->PictureName(i) : set.paths[i];
}

/// Calls `take` with each picture that can be decoded.
Status ForPictures(const PictureSet& set, const std::vector<size_t>& indices, const std::function<bool()>& should_stop,
                   const std::function<void(size_t, const cv::Mat&)>& take) {
  for (const size_t index : indices) {
    if (should_stop && should_stop()) break;
    const auto images = LoadPicture(set, index);
    if (!images) return images.error();
    if (!images->grey.empty()) take(index, images->grey);
  }
  return Status::Ok();
}

Status MeasureTen(const PictureSet& set, const FeaturesBenchOptions& options, FeaturesReport& report) {
  std::vector<size_t> ten;
  const size_t first = set.size() > kPaperPictures ? (set.size() - kPaperPictures) / 2 : 0;
  for (size_t i = first; i < std::min(set.size(), first + kPaperPictures); ++i) ten.push_back(i);
  SpreadTable spread(options.features);
  const Status done =
      ForPictures(set, ten, options.should_stop, [&](size_t, const cv::Mat& grey) { spread.Add(grey, kRounds); });
  report.ten_dispersions = spread.dispersions();
  report.ten_times_ms = spread.times_ms();
  return done;
}

std::vector<FrontEnd> FrontEndsToMatch(const FeatureOptions& ours) {
  std::vector<FrontEnd> chosen;
  for (FrontEnd& f : FrontEnds(ours)) {
    if (f.name != front_end::kOriginalPath) chosen.push_back(std::move(f));
  }
  return chosen;
}

Status MeasureMatching(const PictureSet& set, const std::vector<size_t>& indices, const FeaturesBenchOptions& options,
                       FeaturesReport& report) {
  const std::vector<FrontEnd> front_ends = FrontEndsToMatch(options.features);
  if (!set.HasMotion()) {
    auto row = MatchUnderLight(set, indices, front_ends, options.should_stop);
    if (!row) return row.error();
    report.matching.push_back(*std::move(row));
    return Status::Ok();
  }
  for (const size_t gap : {size_t{1}, kFarGap}) {
    auto row = MatchAlongMotion(set, indices, gap, front_ends, options.should_stop);
    if (!row) return row.error();
    report.matching.push_back(*std::move(row));
  }
  return Status::Ok();
}

}  // namespace

Result<FeaturesReport> MeasureFeatures(const PictureSet& set, const FeaturesBenchOptions& options) {
  const OneThread one_thread;
  const std::vector<size_t> indices = Spread(set.size(), options.pictures);
  FeaturesReport report;
  report.set = set.name;
  LightTable light(options.features);
  SpreadTable spread(options.features);
  const Status counted = ForPictures(set, indices, options.should_stop, [&](size_t i, const cv::Mat& grey) {
    light.Add(grey, PictureNameOf(set, i));
    spread.Add(grey, kRounds);
    ++report.pictures;
  });
  if (!counted) return counted.error();
  report.light = light.rows();
  report.corners = light.corners();
  report.shares = light.shares();
  report.dispersions = spread.dispersions();
  report.times_ms = spread.times_ms();
  if (const Status ten = MeasureTen(set, options, report); !ten) return ten.error();
  if (const Status matched = MeasureMatching(set, indices, options, report); !matched) return matched.error();
  return report;
}

}  // namespace yorb

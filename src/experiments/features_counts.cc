// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/features_counts.h"

#include <algorithm>
#include <limits>

namespace yorb {
namespace {

constexpr double kEnough = 0.7;  // of the wanted points: less is starved

/// The front ends of the second row: ours, the original with both pairs of thresholds, cv::ORB.
std::vector<FrontEnd> WithoutOriginalPath(std::vector<FrontEnd> front_ends) {
  const auto is_path = [](const FrontEnd& f) { return f.name == front_end::kOriginalPath; };
  front_ends.erase(std::remove_if(front_ends.begin(), front_ends.end(), is_path), front_ends.end());
  return front_ends;
}

void AddChange(size_t before, size_t after, Mean& mean) {
  if (before >= kFewestCorners) mean.Add(static_cast<double>(after) / static_cast<double>(before) - 1);
}

}  // namespace

double Mean::value() const {
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
}

LightTable::LightTable(const FeatureOptions& ours)
    : wanted_(ours.wanted),
      counters_(CornerCounters(ours)),
      front_ends_(WithoutOriginalPath(FrontEnds(ours))),
      changes_(LightChanges()) {
  for (const LightChange& change : changes_) rows_.push_back({change.name, {}, {}});
}

void LightTable::AddShares(const std::vector<size_t>& found, const std::string& name) {
  std::map<std::string, double> of;
  for (size_t f = 0; f < front_ends_.size(); ++f) {
    of[front_ends_[f].name] = std::min(1.0, static_cast<double>(found[f]) / wanted_);
  }
  for (const auto& [front_end, share] : of) {
    FoundShare& sum = shares_[front_end];
    sum.mean.Add(share);
    sum.under_70 += share < kEnough;
    sum.under_70_alone += share < kEnough && of[front_end::kOriginal] >= kEnough;
    if (share < sum.lowest || sum.starved.empty()) sum.lowest = share, sum.starved = name;
  }
}

void LightTable::Add(const cv::Mat& grey, const std::string& name) {
  std::vector<size_t> corners, features;
  for (const CornerCounter& counter : counters_) {
    corners.push_back(counter.count(grey));
    corners_[counter.name].Add(static_cast<double>(corners.back()));
  }
  for (const FrontEnd& front_end : front_ends_) features.push_back(front_end.extract(grey).keypoints.size());
  AddShares(features, name);
  for (size_t c = 0; c < changes_.size(); ++c) {
    const cv::Mat relit = Relit(grey, changes_[c]);
    for (size_t i = 0; i < counters_.size(); ++i) {
      AddChange(corners[i], counters_[i].count(relit), rows_[c].corners[counters_[i].name]);
    }
    for (size_t f = 0; f < front_ends_.size(); ++f) {
      AddChange(features[f], front_ends_[f].extract(relit).keypoints.size(), rows_[c].features[front_ends_[f].name]);
    }
  }
}

}  // namespace yorb

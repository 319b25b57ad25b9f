// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/result.h"
#include "experiments/features_front_ends.h"
#include "experiments/features_light.h"

namespace yorb {

/// A mean that grows; NaN while empty.
struct Mean {
  double sum = 0;
  size_t count = 0;

  void Add(double value) { sum += value, ++count; }
  double value() const;
};

/// Table 3: how counts change with the light, as fractions (-0.63: 63 % fewer), means over the pictures, by the name of
/// the front end. Pictures with fewer than kFewestCorners of a kind say nothing about it and are left out of it.
struct LightRow {
  std::string change;
  std::map<std::string, Mean> corners;   ///< of the first threshold, all levels, before distribution, no cap
  std::map<std::string, Mean> features;  ///< what the whole extractor gives
};

constexpr size_t kFewestCorners = 20;

/// How many of the wanted points a front end finds, in pictures as they are.
struct FoundShare {
  Mean mean;                  ///< of min(1, found / wanted)
  double lowest = 1;          ///< of one picture
  std::string starved;        ///< the picture with the lowest share
  size_t under_70 = 0;        ///< pictures with less than 70 % of the wanted points
  size_t under_70_alone = 0;  ///< of these, pictures in which the original (20/7) finds 70 %
};

/// Table 3 as it grows picture by picture.
class LightTable {
 public:
  explicit LightTable(const FeatureOptions& ours);

  void Add(const cv::Mat& grey, const std::string& name);

  const std::vector<LightRow>& rows() const { return rows_; }
  const std::map<std::string, Mean>& corners() const { return corners_; }  ///< a picture, as it is
  const std::map<std::string, FoundShare>& shares() const { return shares_; }

 private:
  void AddShares(const std::vector<size_t>& found, const std::string& name);

  int wanted_;
  std::vector<CornerCounter> counters_;
  std::vector<FrontEnd> front_ends_;
  std::vector<LightChange> changes_;
  std::vector<LightRow> rows_;
  std::map<std::string, Mean> corners_;
  std::map<std::string, FoundShare> shares_;
};

}  // namespace yorb

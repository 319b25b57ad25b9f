// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/result.h"
#include "experiments/features_counts.h"
#include "experiments/features_matching.h"
#include "experiments/features_pictures.h"

namespace yorb {

/// What to measure, and on how many pictures.
struct FeaturesBenchOptions {
  FeatureOptions features;            ///< ours
  size_t pictures = 100;              ///< of each set, evenly spread; 0: all
  std::function<bool()> should_stop;  ///< asked between pictures
};

/// Tables 3 to 5 of the paper for one set of pictures.
struct FeaturesReport {
  std::string set;
  size_t pictures = 0;
  std::vector<LightRow> light;                                               ///< Table 3
  std::map<std::string, Mean> corners;                                       ///< first threshold, a picture as it is
  std::map<std::string, FoundShare> shares;                                  ///< of the wanted points
  std::map<std::string, std::vector<double>> dispersions, times_ms;          ///< Table 4, the pictures above
  std::map<std::string, std::vector<double>> ten_dispersions, ten_times_ms;  ///< Table 4, ten consecutive pictures
  std::vector<MatchingRow> matching;                                         ///< Table 5
};

/// Runs all experiments of the paper's first part on a set. One thread; sets OpenCV to one thread while it works.
Result<FeaturesReport> MeasureFeatures(const PictureSet& set, const FeaturesBenchOptions& options);

/// The tables for people, set by set.
std::string FeaturesText(const std::vector<FeaturesReport>& reports);

/// {"brightness", "time", "dispersion", "matching", "sets"}: the first four over all pictures of all sets.
std::string FeaturesJson(const std::vector<FeaturesReport>& reports);

}  // namespace yorb

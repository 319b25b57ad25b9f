// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/features_counts.h"
#include "experiments/features_front_ends.h"

namespace yorb {

/// Equation (5): the standard deviation of the counts in the nine cells of a 3x3 grid.
double Dispersion(const std::vector<Keypoint>& keypoints, const cv::Size& size);

/// The time that the calling thread has spent on a processor, in milliseconds: a busy machine does not lengthen it.
double ThreadCpuMs();

/// Table 4: dispersion and processor time of each front end, picture by picture.
class SpreadTable {
 public:
  explicit SpreadTable(const FeatureOptions& ours);

  /// Extracts `rounds` times with each front end, taking turns, and counts the fastest of each.
  void Add(const cv::Mat& grey, int rounds);

  /// By front end, in the order of the pictures.
  const std::map<std::string, std::vector<double>>& dispersions() const { return dispersions_; }
  const std::map<std::string, std::vector<double>>& times_ms() const { return times_ms_; }

 private:
  std::vector<FrontEnd> front_ends_;
  std::map<std::string, std::vector<double>> dispersions_, times_ms_;
};

}  // namespace yorb

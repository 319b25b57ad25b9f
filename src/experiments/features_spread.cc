// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/features_spread.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>

namespace yorb {

double Dispersion(const std::vector<Keypoint>& keypoints, const cv::Size& size) {
  constexpr int kSide = 3, kCells = kSide * kSide;
  std::array<int, kCells> counts{};
  for (const Keypoint& k : keypoints) {
    const int column = std::clamp(static_cast<int>(k.x * kSide / static_cast<float>(size.width)), 0, kSide - 1);
    const int row = std::clamp(static_cast<int>(k.y * kSide / static_cast<float>(size.height)), 0, kSide - 1);
    ++counts[static_cast<size_t>(row * kSide + column)];
  }
  const double mean = static_cast<double>(keypoints.size()) / kCells;
  double sum = 0;
  for (const int count : counts) sum += (count - mean) * (count - mean);
  return std::sqrt(sum / kCells);
}

double ThreadCpuMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

SpreadTable::SpreadTable(const FeatureOptions& ours) : front_ends_(FrontEnds(ours)) {}

void SpreadTable::Add(const cv::Mat& grey, int rounds) {
  std::vector<double> fastest_ms(front_ends_.size(), std::numeric_limits<double>::infinity());
  for (int round = 0; round < rounds; ++round) {
    for (size_t f = 0; f < front_ends_.size(); ++f) {
      const double start_ms = ThreadCpuMs();
      const Features features = front_ends_[f].extract(grey);
      fastest_ms[f] = std::min(fastest_ms[f], ThreadCpuMs() - start_ms);
      if (round == 0) dispersions_[front_ends_[f].name].push_back(Dispersion(features.keypoints, grey.size()));
    }
  }
  for (size_t f = 0; f < front_ends_.size(); ++f) times_ms_[front_ends_[f].name].push_back(fastest_ms[f]);
}

}  // namespace yorb

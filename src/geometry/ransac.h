// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/options.h"
#include "core/random.h"

namespace yorb {

struct RansacOptions {
  int max_iterations = 300;   ///< samples at most
  double confidence = 0.999;  ///< stop when a sample of inliers only has been drawn with this probability

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_iterations", self.max_iterations, Range(1, 100000));
    visit("confidence", self.confidence, Range(0.5, 0.999999));
  }
};

/// How well a model fits all data: less cost is better.
struct RansacScore {
  double cost = std::numeric_limits<double>::infinity();
  size_t num_inliers = 0;
};

template <typename Model>
struct RansacBest {
  Model model;
  RansacScore score;
  int iterations = 0;
};

/// How many samples of `sample_size` it takes until one holds inliers only, with the wanted confidence.
inline double SamplesNeeded(double inlier_fraction, size_t sample_size, double confidence) {
  const double all_good = std::pow(inlier_fraction, static_cast<double>(sample_size));
  if (all_good >= 1) return 1;
  if (all_good <= 0) return std::numeric_limits<double>::infinity();
  return std::max(1.0, std::log1p(-confidence) / std::log1p(-all_good));
}

/// `kSize` different numbers below `count`, which is at least `kSize`.
template <size_t kSize>
std::array<uint32_t, kSize> DrawSample(uint32_t count, Random& random) {
  std::array<uint32_t, kSize> sample{};
  for (size_t k = 0; k < kSize; ++k) {
    do sample[k] = random.Below(count);
    while (std::find(sample.begin(), sample.begin() + k, sample[k]) != sample.begin() + k);
  }
  return sample;
}

/// The model of least cost among those of random minimal samples; nothing when no sample gives a model.
/// `solve(sample)` gives a range of models; `score(model, cost_to_beat)` may stop early once its cost is higher.
template <typename Model, size_t kSize, typename Solve, typename Score>
std::optional<RansacBest<Model>> Ransac(size_t count, const RansacOptions& options, Random random, Solve&& solve,
                                        Score&& score) {
  if (count < kSize) return std::nullopt;
  std::optional<RansacBest<Model>> best;
  double needed = options.max_iterations;
  int iteration = 0;
  for (; iteration < needed; ++iteration) {
    for (const Model& model : solve(DrawSample<kSize>(static_cast<uint32_t>(count), random))) {
      const double to_beat = best ? best->score.cost : std::numeric_limits<double>::infinity();
      const RansacScore result = score(model, to_beat);
      if (!(result.cost < to_beat)) continue;
      best = RansacBest<Model>{model, result, 0};
      const double fraction = static_cast<double>(result.num_inliers) / static_cast<double>(count);
      needed = std::min<double>(options.max_iterations, SamplesNeeded(fraction, kSize, options.confidence));
    }
  }
  if (best) best->iterations = iteration;
  return best;
}

}  // namespace yorb

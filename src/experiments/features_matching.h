// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "experiments/features_front_ends.h"
#include "experiments/features_pictures.h"

namespace yorb {

/// Matches of one front end, summed over pairs of pictures.
struct MatchCount {
  size_t pairs = 0, matches = 0, correct = 0;

  /// Equation (6) as a fraction; NaN without matches.
  double Precision() const;
  double MatchesPerPair() const;
};

/// Table 5 for one set of pairs.
struct MatchingRow {
  std::string set;
  std::vector<std::pair<std::string, MatchCount>> counts;                 ///< by front end
  std::vector<std::pair<std::string, std::vector<MatchCount>>> by_light;  ///< by light, then by front end as above
};

/// Pairs of rows that are each other's nearest by Hamming distance (of equal ones the first), in the order of `a`.
std::vector<std::pair<size_t, size_t>> MutualNearest(const std::vector<Descriptor>& a,
                                                     const std::vector<Descriptor>& b);

/// A match is right within so many pixels of the level that its first point was found on.
constexpr float kRightWithin_px = 3;

/// How far each match is off, in pixels of the picture; NaN where the truth is not known there.
using MatchErrors = std::vector<float>;

/// Where picture and point do not move.
MatchErrors ErrorsInPlace(const Features& a, const Features& b, const std::vector<std::pair<size_t, size_t>>& matches);

/// By the depth of the first picture and the true motion between both.
MatchErrors ErrorsByMotion(const Features& a, const Features& b, const std::vector<std::pair<size_t, size_t>>& matches,
                           const Rig& rig, const DepthImage& depth_of_a, const Rigid3& b_from_a);

/// Whether each match is right: 1, wrong: 0, or nobody knows: -1.
std::vector<int> Verdicts(const Features& a, const std::vector<std::pair<size_t, size_t>>& matches,
                          const MatchErrors& errors);

/// Each of `indices` against itself under every light; the sum over lights, and each by itself.
Result<MatchingRow> MatchUnderLight(const PictureSet& set, const std::vector<size_t>& indices,
                                    const std::vector<FrontEnd>& front_ends, const std::function<bool()>& should_stop);

/// Frame i against frame i + gap, judged by the true motion; matches whose place is not known do not count.
Result<MatchingRow> MatchAlongMotion(const PictureSet& set, const std::vector<size_t>& indices, size_t gap,
                                     const std::vector<FrontEnd>& front_ends, const std::function<bool()>& should_stop);

}  // namespace yorb

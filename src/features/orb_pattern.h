// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace yorb {

/// One test of the ORB descriptor: is the blurred pixel at (x1, y1) darker than the one at (x2, y2)?
struct OrbPair {
  int8_t x1, y1, x2, y2;
};

/// The 256 learned pairs of Rublee et al., "ORB: an efficient alternative to SIFT or SURF", ICCV 2011, as published in
/// OpenCV (see NOTICE). Pixels about the keypoint, before rotation.
extern const std::array<OrbPair, 256> kOrbPairs;

/// No coordinate is farther than this from the keypoint, however the pattern is rotated and rounded.
constexpr int kOrbPatternRadius = 18;

}  // namespace yorb

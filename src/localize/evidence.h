// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "localize/fix.h"
#include "map/map.h"

namespace yorb {

/// What should be seen from a pose, and how much of it is. A poster on two walls gives a pose that fits its own points
/// to the pixel; but what hangs around it in the one place is not to be found in the other. So it counts in how many
/// parts of the picture something is found, too: chairs that moved cost a part or two, a poster has but its own.
struct Evidence {
  size_t num_expected = 0;  ///< landmarks in view where the frame has something to compare
  size_t num_found = 0;     ///< of these, matched
  size_t num_parts = 0;     ///< of the picture, with enough that is expected
  size_t num_parts_found = 0;

  double Share() const { return Ratio(num_found, num_expected); }
  double Spread() const { return Ratio(num_parts_found, num_parts); }

 private:
  static double Ratio(size_t part, size_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// Weighs a fix by what these keyframes see. A landmark counts where the frame has a keypoint near the place at which
/// it should appear, and nothing that stands before it: where people were taken out of the picture, nothing is missing.
Evidence Weigh(const Frame& frame, const Map& map, const Fix& fix, const std::vector<KeyframeId>& keyframes);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "localize/fix.h"
#include "map/map.h"

namespace yorb {

/// What should be seen from a pose, and how much of it is. A poster on two walls gives a pose that fits its own points
/// to the pixel; but what hangs around it in the one place is not to be found in the other. So it counts over how much
/// of the picture the finds are spread, too.
struct Evidence {
  size_t num_expected = 0;  ///< landmarks in view where the frame has something to compare
  size_t num_found = 0;     ///< of these, matched
  double spread = 0;        ///< area over which those that were found scatter, as a share of that of all expected ones

  double Share() const {
    return num_expected == 0 ? 0 : static_cast<double>(num_found) / static_cast<double>(num_expected);
  }
};

/// Weighs a fix by what these keyframes see. A landmark counts where the frame has a keypoint near the place at which
/// it should appear, and nothing that stands before it: where people were taken out of the picture, nothing is missing.
Evidence Weigh(const Frame& frame, const Map& map, const Fix& fix, const std::vector<KeyframeId>& keyframes);

}  // namespace yorb

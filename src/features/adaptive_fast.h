// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "features/fast.h"

namespace yorb {

/// How the corners of one level are chosen.
struct CornerOptions {
  bool is_adaptive = true;  ///< thresholds by equation (3), for each pixel; otherwise the fixed ones
  int high = 20, low = 7;   ///< grey levels; not adaptive
  double alpha = 0.7;       ///< the first threshold is alpha times the trimmed mean of the ring: equation (3)
  double alpha_low = 0.07;  ///< the second one, of the same kind
  int noise = 4;            ///< grey levels that a corner must exceed under any light; adaptive
  int arc = 9;              ///< contiguous ring pixels that make a corner
  int border = 19;          ///< pixels that stay empty along the edges
};

/// FAST with two thresholds: a cell of about 30 px in which the first one finds nothing gets the corners of the second.
class CornerDetector {
 public:
  /// Row by row, left to right. The result lives until the next call.
  const std::vector<Corner>& Detect(const GreyView& level, const CornerOptions& options, Instructions instructions);

 private:
  Fast fast_;
  std::vector<int> firsts_;        ///< how many corners the first threshold finds in each cell
  std::vector<uint32_t> cells_;    ///< of each candidate
  std::vector<uint8_t> is_first_;  ///< whether a candidate passes the first threshold
  std::vector<Corner> candidates_, corners_;
};

}  // namespace yorb

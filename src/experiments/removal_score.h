// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"
#include "datasets/dataset.h"
#include "system/slam.h"

namespace yorb {

/// What was decided about the points of the pictures of a run.
class JudgedPoints {
 public:
  /// Notes the points of one picture; cheap, so that the times of the run stay true.
  void Add(const Watched& watched);

  struct Point {
    float x = 0, y = 0;  ///< pixels of the colour picture
    bool is_removed = false;
  };
  struct Picture {
    Timestamp time;
    std::vector<Point> points;
  };
  const std::vector<Picture>& pictures() const { return pictures_; }

 private:
  std::vector<Picture> pictures_;
};

/// Points by what was decided and what is true: a point on a pixel of a moving thing should be removed.
struct RemovalScore {
  size_t num_removed_rightly = 0, num_removed_wrongly = 0, num_kept_wrongly = 0, num_kept_rightly = 0;

  /// Which share of what was removed moves; which share of what moves was removed. NaN where there is none.
  double Precision() const;
  double Recall() const;
};

/// Compares with the true masks (a folder of PNGs by colour time stamp or file name, not 0 on what moves). Pictures
/// without a mask do not count. Bad input where no mask fits, or one cannot be read.
Result<RemovalScore> ScoreRemoval(const JudgedPoints& judged, const Dataset& dataset, const std::string& masks);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "map/map.h"
#include "mapping/mapper.h"
#include "system/slam.h"

namespace yorb {

/// What has happened to each frame, and how long each stage took. Any thread may call anything.
class FrameLog {
 public:
  /// A frame that was added before is known better now; its times count as they were.
  void Add(const FrameRecord& record);
  void Add(const MappingTimes& times);
  void Add(const std::string& stage, double ms);

  size_t num_frames() const;

  /// Everything so far, with the poses that `map` gives the frames now, one by one or as the likeliest path
  /// (`SmoothTrajectory`). Sub-maps with keyframes before `first_own`, of a map that was gone on from, come first:
  /// trajectory.txt is in its world, or empty.
  SlamReport Report(const Map& map, KeyframeId first_own, bool smooth) const;

 private:
  mutable std::mutex mutex_;
  std::vector<FrameRecord> records_;
  std::map<std::string, std::vector<double>> stage_ms_;
  size_t num_landmarks_gone_ = 0;
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/result.h"
#include "datasets/dataset.h"
#include "system/slam.h"

namespace yorb {

/// What became of a colour picture of the list on its way in.
enum class Fate : unsigned char {
  kPushed,   ///< handed to the SLAM system
  kSkipped,  ///< could not be decoded whole
  kDropped,  ///< live: the system was not ready for it
};

/// How the feeding of a recording went, or goes.
struct FeedLog {
  std::vector<Fate> fates;      ///< one a colour picture, in the order of the list, as far as it was read
  std::vector<double> read_ms;  ///< time to read and decode the pictures of a frame
  size_t num_skipped = 0;       ///< colour and depth pictures and masks that could not be decoded whole
  bool had_depth = false;       ///< in at least one frame
  bool was_stopped = false;     ///< should_stop said so
  std::optional<Error> error;   ///< why the run could not go on
};

/// What the feeder asks and tells, in the caller's thread. Each may be empty.
struct FeedHooks {
  std::function<bool()> should_stop;                ///< asked before each frame, and while live mode waits
  std::function<void(const FeedLog&)> after_frame;  ///< told after each frame
};

/// How many frames of the recording the configuration asks for.
size_t FramesToFeed(const Dataset& dataset, const Config& config);

/// Plays a recording into a SLAM system: pictures are read ahead by another thread; live mode waits between two frames
/// as long as they were apart, at most a second. Returns when all is pushed and worked off, or the run cannot go on.
FeedLog Feed(const Dataset& dataset, const Config& config, Slam& slam, const FeedHooks& hooks);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: runs. One recording into one folder of results.
// Takes: Dataset, Config. Gives: RunSummary, the files of RUNDIR. Owns: the reader thread (through core/prefetch.h).
// Runs on: the caller's thread. May not: print, know the command line, take the truth for anything but the report.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "core/result.h"
#include "datasets/dataset.h"
#include "geometry/trajectory.h"
#include "system/config.h"

namespace yorb {

/// What is run, and where the results go.
struct RunOptions {
  Config config;
  std::string out;           ///< the folder for the results; empty: a new one, yorb_DATE_TIME
  std::string title;         ///< of the report: the recording's name
  Trajectory reference;      ///< the truth, for the report's error plots alone; empty: none
  std::string save_map;      ///< a file for the map, written at every end; empty: none
  std::string overlay;       ///< a folder for pictures of what is removed; empty: none
  double save_every_s = 30;  ///< a power cut costs so much
};

/// How far a run has come.
struct RunProgress {
  size_t num_done = 0;    ///< frames worked off
  size_t num_frames = 0;  ///< of so many
};

/// What a run asks and tells, in the caller's thread. Each may be empty.
struct RunHooks {
  std::function<bool()> should_stop;
  std::function<void(const RunProgress&)> on_progress;
};

/// What came of a run.
struct RunSummary {
  std::string out;  ///< the folder with the results
  std::string map;  ///< the file that the map was written to; empty: none was
  size_t frames = 0, tracked = 0, skipped = 0, dropped = 0, keyframes = 0, landmarks = 0;
  double wall_s = 0;
  bool was_stopped = false;
  std::optional<Error> error;  ///< why it ended early; what was computed until then is written
};

/// Runs a recording and writes all files of the run folder, every half a minute and at the end, whatever the end is.
/// An error, and nothing written, where the run could not even begin. Warnings and log lines go to the log, which the
/// caller has started with `keeps_text` if log.txt shall hold more than nothing.
Result<RunSummary> RunSequence(const Dataset& dataset, const RunOptions& options, const RunHooks& hooks);

}  // namespace yorb

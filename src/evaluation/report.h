// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/time.h"
#include "geometry/trajectory.h"

namespace yorb {

/// One picture of a run, as report.html draws it.
struct ReportFrame {
  Timestamp timestamp;
  std::string state;  ///< the word of frames.csv: tracking, recently_lost, lost, not_initialized, skipped ...
  int matched = 0;
  int inliers = 0;
  double frame_total_ms = 0;
};

/// How long one stage took.
struct ReportStage {
  std::string name;  ///< as in metrics.json: "extract", "track", "frame_total" ...
  double median_ms = 0, p95_ms = 0, max_ms = 0;
  size_t count = 0;
};

/// What report.html shows. Everything may be left empty: what is not known is not drawn.
struct RunReport {
  std::string title;                                             ///< the sequence's name, say
  std::vector<std::pair<std::string, std::string>> key_figures;  ///< label and value, in the order of their importance
  Trajectory trajectory;                                         ///< estimated, a pose a tracked frame
  Trajectory keyframes;                                          ///< estimated, in the same frame
  Trajectory reference;                                          ///< the truth; empty: none
  std::vector<ReportFrame> frames;                               ///< every picture, in the order of time
  std::vector<ReportStage> stages;                               ///< in the order to be listed
  std::optional<double> coverage;  ///< share of the pictures with a confirmed pose, 0 to 1
  std::string config_digest;
  std::string version;
  std::vector<std::string> notes;  ///< a sentence each, such as warnings of the run
};

/// report.html: one self-contained page (no network, no other files). The estimate is aligned to the reference by
/// SE(3), and its error drawn, where both have at least three poses in common.
std::string ReportHtml(const RunReport& report);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "system/config.h"

namespace yorb {

/// A wish for a dense cloud.
struct DenseRequest {
  std::optional<std::string> sequence;  ///< whose depth pictures are taken; none: the landmarks are exported
  double cube_m = 0.01;                 ///< of the points in a cube of this side one stays
  Config config = WithPeopleLeftOut();  ///< dynamics, detections, masks and the detector count
  std::string named_option;             ///< one of those above that the user named, such as "--cube"; empty: none

  static Config WithPeopleLeftOut() {
    Config config;
    config.dynamics = "full";
    return config;
  }
};

/// What came of an export, in lines for people.
struct ExportReport {
  std::vector<std::string> lines;
  bool was_stopped = false;  ///< nothing was written then
};

/// Reads a map and writes what the ending of `out` says; whole files or none. What cannot be done is refused before the
/// work begins.
Result<ExportReport> ExportMap(const std::string& file, const std::string& out, const DenseRequest& dense,
                               const std::function<bool()>& should_stop);

}  // namespace yorb

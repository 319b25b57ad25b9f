// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "experiments/light.h"

namespace yorb {

/// One run in a line: what was run, error, coverage, time.
std::string LightRunText(const LightRun& run);

/// A row a light and front end, over all seeds: error, the same in units of steady light's, coverage, points found and
/// tracked.
std::string LightText(const LightReport& report);

/// {"frames", "seeds", "rows": [{"light", "front_end", "ate_m", "ate_ratio", "coverage", "features": {"mean", "min"},
/// "points": {"mean", "min"}, "runs": [{"seed", "ate_m", "coverage"}]}]}; null without truth.
std::string LightJson(const LightReport& report);

/// Brightness, points found and points tracked over time, one line a front end; the first seed. SVG.
std::string LightSheet(const LightReport& report, LightKind light);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "experiments/dynamic.h"

namespace yorb {

/// One run in a line: what was run, error, coverage, time.
std::string DynamicRunText(const DynamicRun& run);

/// Tables of errors and reductions (the paper's Table 8), beside published figures where there are some (Table 9), of
/// the removal, and of times (Table 10).
std::string DynamicText(const DynamicReport& report);

/// {"rows": [{"sequence", "way", "frames", "ate_m": {"rmse", "mean", "std", "rmse_spread"}, "reduction_percent":
/// {"rmse", "mean", "std"}, "rpe": {"translation_m", "rotation_deg"}, "coverage", "points": {"removed", "given_back"},
/// "removal": {"precision", "recall"}, "stage_ms", "runs": [{"seed", "ate_m", "coverage"}]}], "averages": [{"way",
/// "sequences", "reduction_percent"}], "published": {"ate_m": [{"sequence", "system", "rmse"}], "frame_ms": [...],
/// "reduction_percent": [...]}}; null where nothing can be said. Published figures are their authors', not measured.
std::string DynamicJson(const DynamicReport& report);

}  // namespace yorb

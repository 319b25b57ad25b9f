// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "evaluation/report.h"

namespace yorb {

/// A number as JSON; null for what is none (NaN, infinite), since JSON has no word for it.
nlohmann::ordered_json NumberOrNull(double value);

/// {"median_ms", "p95_ms", "max_ms", "count"}; null where nothing was measured.
nlohmann::ordered_json StageJson(const ReportStage& stage);

/// The same for many: an object with a member a stage.
nlohmann::ordered_json StagesJson(const std::vector<ReportStage>& stages);

}  // namespace yorb

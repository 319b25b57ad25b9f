// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/stage_json.h"

#include <cmath>

namespace yorb {

nlohmann::ordered_json NumberOrNull(double value) {
  if (!std::isfinite(value)) return nullptr;
  return value;
}

nlohmann::ordered_json StageJson(const ReportStage& stage) {
  const auto number = [&](double value) { return stage.count == 0 ? nlohmann::ordered_json() : NumberOrNull(value); };
  return {{"median_ms", number(stage.median_ms)},
          {"p95_ms", number(stage.p95_ms)},
          {"max_ms", number(stage.max_ms)},
          {"count", stage.count}};
}

nlohmann::ordered_json StagesJson(const std::vector<ReportStage>& stages) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const ReportStage& stage : stages) json[stage.name] = StageJson(stage);
  return json;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "evaluation/report.h"
#include "runs/results.h"
#include "runs/run.h"
#include "system/slam.h"

namespace yorb {

/// What report.html shows of a run.
RunReport ReportOf(const RunOptions& options, const RunMetrics& metrics, const std::vector<FrameRow>& rows,
                   const SlamReport& slam);

}  // namespace yorb

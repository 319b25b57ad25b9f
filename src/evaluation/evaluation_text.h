// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluate.h"

namespace yorb {

/// One estimate: the document that INTERFACE of `yorb eval --json` describes. Several: `{"estimates": [...], "mean",
/// "std"}`, each with its "file". Strict JSON; null where nothing can be said.
std::string EvaluationJson(const std::vector<Evaluation>& evaluations, const EvalOptions& options);

/// The same for reading: one estimate in full, several as a table with mean and standard deviation (over n).
std::string EvaluationText(const std::vector<Evaluation>& evaluations, const EvalOptions& options);

/// A line a pair: stamps, error, both positions, and the estimate's file.
std::string EvaluationCsv(const std::vector<Evaluation>& evaluations, const Trajectory& reference);

/// Path, coordinates and error of all estimates beside the reference, in one SVG file.
std::string EvaluationSvg(const std::vector<Evaluation>& evaluations, const Trajectory& reference);

/// "0.02 m" and the like: a length in the unit that suits it.
std::string LengthText(double metres);

}  // namespace yorb

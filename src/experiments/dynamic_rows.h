// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "experiments/dynamic.h"

namespace yorb {

/// The three figures of the absolute error that are compared.
struct ErrorFigures {
  double rmse = std::numeric_limits<double>::quiet_NaN();
  double mean = rmse;
  double std = rmse;
};

/// One recording dealt with in one way: means over the runs, NaN where a run has no figure.
struct DynamicRow {
  std::string sequence, way;
  std::vector<const DynamicRun*> runs;
  ErrorFigures ate_m;
  double ate_spread_m = 0;        ///< standard deviation of the RMSE over the runs
  ErrorFigures reduction_share;   ///< against `original`; 0.9: a tenth is left
  double rpe_m = 0, rpe_deg = 0;  ///< RMSE over one second
  double coverage = 0;
  double num_removed = 0, num_given_back = 0;  ///< points a picture
  double precision = 0, recall = 0;            ///< of the removal, all runs' points together
  std::map<std::string, double> stage_ms;      ///< medians over the frames of all runs
};

/// In the order in which they were run. The rows point into the report.
std::vector<DynamicRow> DynamicRows(const DynamicReport& report);

/// The reductions of each way, averaged over the sequences that have one.
struct AverageReduction {
  std::string way;
  size_t num_sequences = 0;
  ErrorFigures reduction_share;
};
std::vector<AverageReduction> AverageReductions(const std::vector<DynamicRow>& rows);

/// The names of the sequences, each once, in the order of the rows.
std::vector<std::string> SequencesOf(const std::vector<DynamicRow>& rows);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"

namespace yorb {

/// Where log lines go. Before `StartLog` and after `StopLog`: warnings and errors to standard error, the rest nowhere.
struct LogOptions {
  std::string file;         ///< also written to this file, at information level; empty: no file
  bool to_stdout = false;   ///< information lines also to standard output (not with --quiet or --json)
  bool keeps_text = false;  ///< information lines are also kept in memory, for LogText
  int repeats_shown = 3;    ///< so many warnings of one kind are shown, the rest is counted and summed up at the end
};

/// Opens the log. One log a process. Bad input when the file cannot be written.
Status StartLog(const LogOptions& options);

/// Writes "... and N more of the kind" for every kind that went over `repeats_shown` since the last time.
void SumUpWarnings();

/// Sums up the warnings, then closes the file. Failure when the file could not be written whole.
Status StopLog();

/// What was logged since StartLog, with times, where the options asked for it to be kept; also after StopLog. Lines
/// beyond the first 200 kB are left out.
std::string LogText();

/// One line an event; numbers with units. Any thread may call these.
void LogInfo(const std::string& line);
void LogError(const std::string& line);

/// `kind` is a fixed word such as "picture-skipped": warnings of one kind are shown a few times, then counted.
void LogWarning(const std::string& kind, const std::string& line);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "datasets/dataset.h"
#include "geometry/trajectory.h"
#include "system/config.h"

namespace yorb {

/// What a command does not take: whoever gives the option, which the help leaves out, or sets the key with --set or
/// --config to what is neither the default nor done anyway, is told why.
struct Refused {
  const char* option;        ///< empty: there is none
  const char *key, *why;     ///< of the configuration
  const char* is_done = "";  ///< the value that the command uses
};

/// The options of every command that runs SLAM on a sequence, as they were written.
struct SequenceArguments {
  std::vector<std::string> places;  ///< DIR, and further key=value after --set
  std::optional<std::string> camera, config;
  std::vector<std::string> settings;  ///< of --set
  std::optional<std::string> mode, dynamics, detections, masks, model, seed, max_frames;

  std::vector<Refused> refused;

  /// Adds them to a subcommand, which keeps pointers into this object.
  void AddTo(CLI::App& command, const std::vector<Refused>& not_taken = {});
};

/// A sequence that is ready to run.
struct OpenedSequence {
  std::string folder;
  Config config;
  std::unique_ptr<Dataset> dataset;
};

/// The whole number that was written for an option; bad input, by the option's name, outside of the range.
Result<long long> WholeNumber(const std::string& option, const std::string& text, long long least, long long most);

/// The same of an option that may be left out.
Result<long long> WholeNumber(const std::string& option, const std::optional<std::string>& text, long long otherwise,
                              long long least, long long most);

/// Reads config file and settings (the options above all, then --set, then --config), and opens the sequence.
Result<OpenedSequence> OpenSequence(const SequenceArguments& options);

/// The groundtruth.txt beside the pictures; empty where there is none, which is no fault; a faulty one is.
Result<Trajectory> ReadTruthBeside(const std::string& folder);

}  // namespace yorb

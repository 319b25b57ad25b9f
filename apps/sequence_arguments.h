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

/// An option that a command does not take: its help leaves it out, and whoever gives it is told why.
struct RefusedOption {
  const char *name, *why;
};

/// The options of every command that runs SLAM on a sequence, as they were written.
struct SequenceArguments {
  std::vector<std::string> places;  ///< DIR, and further key=value after --set
  std::optional<std::string> camera, config;
  std::vector<std::string> settings;  ///< of --set
  std::optional<std::string> mode, dynamics, detections, masks, model, seed, max_frames;

  /// Adds them to a subcommand, which keeps pointers into this object.
  void AddTo(CLI::App& command, const std::vector<RefusedOption>& refused = {});
};

/// A sequence that is ready to run.
struct OpenedSequence {
  std::string folder;
  Config config;
  std::unique_ptr<Dataset> dataset;
};

/// The whole number that was written for an option; bad input, by the option's name, outside of the range.
Result<long long> WholeNumber(const std::string& option, const std::string& text, long long least, long long most);

/// Reads config file and settings (the options above all, then --set, then --config), and opens the sequence.
Result<OpenedSequence> OpenSequence(const SequenceArguments& options);

/// The groundtruth.txt beside the pictures; empty where there is none, which is no fault; a faulty one is.
Result<Trajectory> ReadTruthBeside(const std::string& folder);

}  // namespace yorb

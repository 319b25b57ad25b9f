// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "datasets/labelled_set.h"
#include "detection/detector.h"
#include "evaluation/detection_map.h"
#include "runs/unreadable.h"

namespace yorb {

/// What an evaluation came to.
struct DetectorJudgement {
  DetectionScores scores;            ///< labels are numbers of `classes`
  std::vector<std::string> classes;  ///< of the set
  double latency_ms = 0;             ///< median over pictures, from pixels to boxes
  double confidence = 0;             ///< that precision and recall refer to
  size_t num_pictures = 0;           ///< that could be read
  Unreadable unreadable;
};

/// How an evaluation goes about it.
struct JudgeOptions {
  double confidence = 0.25;          ///< for precision and recall
  std::vector<std::string> classes;  ///< only these, by name; none: all
  std::function<bool()> should_stop;
};

/// Lets a detector see every picture of a set and compares its boxes with the truth, classes by name. Pictures that
/// cannot be read are left out, and told of.
Result<DetectorJudgement> JudgeDetector(const LabelledSet& set, Detector& detector, const JudgeOptions& options);

/// A table for people, and {"classes": [...], "map50", "map50_95", "latency_ms", "confidence"}.
std::string JudgementText(const DetectorJudgement& judgement);
std::string JudgementJson(const DetectorJudgement& judgement);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/files.h"
#include "core/result.h"
#include "detection/network_rows.h"
#include "experiments/detector_people.h"
#include "runs/judge_detector.h"

namespace yorb {

/// What `yorb bench detector` measures.
struct DetectorBenchOptions {
  std::vector<std::string> models;      ///< ONNX files
  cv::Size size;                        ///< of all networks' inputs; empty: each as its file says
  std::optional<std::string> labelled;  ///< folder of labelled pictures, for recall, precision and mAP
  std::string set;                      ///< of these pictures
  std::vector<std::string> sequences;   ///< with a people.txt each: how many of those people are found
  double confidence = 0.25;             ///< for precision, recall and the pictures
  size_t rounds = 30;                   ///< timed runs of each network
  std::function<bool()> should_stop;
};

/// One network of the tables 1, 2 and 7.
struct DetectorBenchRow {
  std::string path, name;
  cv::Size size;
  std::string engine;
  NetworkTable table;
  double file_mb = 0;
  double latency_ms = 0;                ///< wall time from picture to boxes, median
  double cpu_ms = 0;                    ///< of this thread, median
  std::optional<double> opencv_cpu_ms;  ///< the same network by OpenCV DNN, runs alternating; nothing where it cannot
  std::optional<DetectorJudgement> judgement;
  std::vector<PeopleScore> people;    ///< one a sequence
  std::vector<std::string> training;  ///< what the file says of its training, "key: value" (table 6)
};

struct DetectorReport {
  std::vector<DetectorBenchRow> networks;

  /// The pictures that no network was judged on, since they could not be read.
  Unreadable unreadable() const;
};

/// Takes every network apart, lets all of them run in turns on one thread over the same picture, and judges them on the
/// same labelled pictures.
Result<DetectorReport> MeasureDetectors(const DetectorBenchOptions& options);

/// The tables for people, and as JSON.
std::string DetectorText(const DetectorReport& report);
std::string DetectorJson(const DetectorReport& report);

/// Figure 9: each picture as every network sees it, side by side, as files below a folder.
struct DetectorFigureFiles {
  std::vector<FileToWrite> files;
  Unreadable unreadable;  ///< pictures without a figure
};
Result<DetectorFigureFiles> DetectorFigures(const std::vector<std::string>& pictures,
                                            const DetectorBenchOptions& options, const std::string& folder);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <utility>

#include "core/result.h"
#include "system/slam.h"

namespace yorb {

/// The picture with what was decided about it: boxes, the mask of moving bodies in red, and points that are static
/// (green), dynamic (red) and given back (yellow).
cv::Mat DrawJudgement(const Watched& watched);

/// Writes DIR/TIMESTAMP.png for each picture, and DIR/points.csv: `timestamp,x,y,level,verdict`.
class OverlayWriter {
 public:
  /// Bad input where the folder cannot be made or written, or holds other pictures. An older overlay stays until Begin.
  static Result<std::shared_ptr<OverlayWriter>> Open(const std::string& folder);

  /// Takes an older overlay away and begins points.csv anew. Before the first Write.
  Status Begin();

  void Write(const Watched& watched);

  /// What went wrong while writing (the disk is full), first of all; fine while all is well.
  const Status& status() const { return status_; }

 private:
  explicit OverlayWriter(std::string folder) : folder_(std::move(folder)) {}

  std::string folder_;
  std::ofstream points_;
  Status status_;
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "camera/rig.h"
#include "datasets/dataset.h"

namespace yorb {

/// Looks at a grid of pixels of a depth picture.
DepthGlance GlanceAt(const DepthImage& depth);

/// Watches the depth that a run reads and warns, once each, where it cannot be meant: a depth factor under which the
/// scene is nearer than 0.1 m or farther than 30 m, and a sequence without any depth. Fed by whoever loads the frames:
/// Add after each Load, Conclude at the end; a camera that is only located needs no depth.
class DepthWatch {
 public:
  explicit DepthWatch(const Rig& rig) : camera_(rig.name), depth_factor_(rig.depth_factor) {}

  void Add(const LoadedFrame& frame);
  void Conclude(bool needs_depth = true);

  /// Whether any frame so far had depth to speak of.
  bool has_seen_any() const { return has_seen_any_; }

  /// What is wrong with a typical depth; empty where nothing is.
  static std::string FactorComplaint(double median_m, bool is_float, double depth_factor, const std::string& camera);

 private:
  void JudgeFactor();

  std::string camera_;
  double depth_factor_;
  size_t num_frames_ = 0;
  bool is_judged_ = false;
  bool is_float_ = false;
  bool has_seen_any_ = false;
  std::vector<double> medians_m_;  // of the frames seen until the judgement
};

}  // namespace yorb

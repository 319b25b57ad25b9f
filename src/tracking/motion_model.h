// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/time.h"
#include "geometry/rigid3.h"

namespace yorb {

/// How a camera moves: `to_from_from` of a short time, divided by it.
struct CameraRate {
  Eigen::Vector3d turn_per_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d shift_per_s = Eigen::Vector3d::Zero();

  /// The step after so many seconds, which may be negative.
  Rigid3 After(double seconds) const { return {RotationFromVector(turn_per_s * seconds), shift_per_s * seconds}; }
};

/// A step that is likely: `information` is of the step of Rigid3::FromStep by which the true one is off.
struct LikelyStep {
  Rigid3 step;
  Matrix6d information;
};

/// Constant velocity, by the clock: a gap of two frames is a step of twice the length.
class MotionModel {
 public:
  /// The step between the two newest confirmed frames.
  void Observe(Timestamp from, Timestamp to, const Rigid3& to_from_from);

  /// The step to expect between two moments; none after a pause, when nothing is known of the motion any more.
  Rigid3 Predict(Timestamp from, Timestamp to) const;

  /// The same with how sure it is, by the accelerations that hands and robots usually have. Nothing where Predict knows
  /// nothing.
  std::optional<LikelyStep> Expect(Timestamp from, Timestamp to) const;

  /// Whether a hand or a robot can have brought the camera there: its speed and turn have changed by no more than
  /// their acceleration allows, from the newest step or, which may have been a little off, the one before. True where
  /// nothing is known of the motion.
  /// `effort`: which share of the possible acceleration is allowed.
  bool CanReach(Timestamp from, Timestamp to, const Rigid3& to_from_from, double effort = 1) const;

  /// Whether the two newest steps agree, so that the next one will be much the same. False where less is known.
  bool IsSteady(double effort) const;

  void Forget() { rate_.reset(), rate_before_.reset(); }

  /// The rate of the newest step; none where nothing is known of it.
  const std::optional<CameraRate>& rate() const { return rate_; }

  /// The rate for a shutter that rolls for `readout_s`. Such a camera gives no picture sooner after another: where the
  /// stamps say so, they are times of arrival, and the step took `readout_s` at least.
  std::optional<CameraRate> RateWhileReading(double readout_s) const;

 private:
  std::optional<CameraRate> rate_, rate_before_;
  double step_s_ = 0;  // over which the newest rate was seen
};

}  // namespace yorb

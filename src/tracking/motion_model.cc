// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/motion_model.h"

#include <cmath>

#include "geometry/usual_motion.h"

namespace yorb {
namespace {

// Cameras that are carried, shaken by hand or driven stay below three quarters of these.
constexpr double kMostAcceleration = 40;      // m/s^2
constexpr double kMostTurnAcceleration = 60;  // rad/s^2

/// Whether acceleration can bring about such a change; `reach` turns it into the change's units.
bool CanChange(double shift, double turn, double reach) {
  return shift <= kMostAcceleration * reach && turn <= kMostTurnAcceleration * reach;
}

}  // namespace

void MotionModel::Observe(Timestamp from, Timestamp to, const Rigid3& to_from_from) {
  const double seconds = SecondsBetween(from, to);
  if (seconds <= 0 || seconds > kLongestPause) return Forget();
  rate_before_ = rate_;
  step_s_ = seconds;
  rate_ = CameraRate{VectorFromRotation(to_from_from.rotation) / seconds, to_from_from.translation / seconds};
}

std::optional<CameraRate> MotionModel::RateWhileReading(double readout_s) const {
  if (!rate_ || step_s_ >= readout_s) return rate_;
  const double share = step_s_ / readout_s;
  return CameraRate{share * rate_->turn_per_s, share * rate_->shift_per_s};
}

Rigid3 MotionModel::Predict(Timestamp from, Timestamp to) const {
  const double seconds = SecondsBetween(from, to);
  if (!rate_ || seconds <= 0 || seconds > kLongestPause) return Rigid3::Identity();
  return rate_->After(seconds);
}

std::optional<LikelyStep> MotionModel::Expect(Timestamp from, Timestamp to) const {
  const double seconds = SecondsBetween(from, to);
  if (!rate_ || seconds <= 0 || seconds > kLongestPause) return std::nullopt;
  const double reach = seconds * (seconds + step_s_) / 2;
  const auto precision = [&](double acceleration) { return 1 / std::pow(acceleration * reach, 2); };
  LikelyStep likely{rate_->After(seconds), Matrix6d::Zero()};
  likely.information.diagonal().head<3>().setConstant(precision(kUsualTurnAcceleration));
  likely.information.diagonal().tail<3>().setConstant(precision(kUsualAcceleration));
  return likely;
}

bool MotionModel::CanReach(Timestamp from, Timestamp to, const Rigid3& to_from_from, double effort) const {
  const double seconds = SecondsBetween(from, to);
  if (!rate_ || seconds <= 0 || seconds > kLongestPause) return true;
  // A rate is the mean over its step: from the middle of one step to the middle of the next it may change.
  const double reach = effort * seconds * (seconds + step_s_) / 2;
  const auto is_near = [&](const CameraRate& rate) {
    const Rigid3 off = to_from_from * rate.After(seconds).Inverse();
    return CanChange(off.translation.norm(), off.RotationAngle(), reach);
  };
  return is_near(*rate_) || (rate_before_ && is_near(*rate_before_));
}

bool MotionModel::IsSteady(double effort) const {
  if (!rate_ || !rate_before_) return false;
  const Eigen::Vector3d turn = rate_->turn_per_s - rate_before_->turn_per_s;
  const Eigen::Vector3d shift = rate_->shift_per_s - rate_before_->shift_per_s;
  return CanChange(shift.norm(), turn.norm(), effort * step_s_);
}

}  // namespace yorb

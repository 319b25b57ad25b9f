// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/motion_model.h"

namespace yorb {
namespace {

constexpr double kLongestPause = 0.3;  // seconds; a hand turns round in that time

}  // namespace

void MotionModel::Observe(Timestamp from, Timestamp to, const Rigid3& to_from_from) {
  const double seconds = SecondsBetween(from, to);
  if (seconds <= 0 || seconds > kLongestPause) return Forget();
  rate_ = CameraRate{VectorFromRotation(to_from_from.rotation) / seconds, to_from_from.translation / seconds};
}

Rigid3 MotionModel::Predict(Timestamp from, Timestamp to) const {
  const double seconds = SecondsBetween(from, to);
  if (!rate_ || seconds <= 0 || seconds > kLongestPause) return Rigid3::Identity();
  return rate_->After(seconds);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/time.h"
#include "geometry/rigid3.h"

namespace yorb {

/// Constant velocity, by the clock: a gap of two frames is a step of twice the length.
class MotionModel {
 public:
  /// The step between the two newest confirmed frames.
  void Observe(Timestamp from, Timestamp to, const Rigid3& to_from_from);

  /// The step to expect between two moments; none after a pause, when nothing is known of the motion any more.
  Rigid3 Predict(Timestamp from, Timestamp to) const;

  void Forget() { rate_.reset(); }

 private:
  struct Rate {
    Eigen::Vector3d turn_per_s, shift_per_s;
  };
  std::optional<Rate> rate_;
};

}  // namespace yorb

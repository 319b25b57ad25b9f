// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

// How a camera moves that is carried, shaken by hand or driven.

/// Standard deviations of the acceleration, by axis. Of the true motions of six hand-held recordings they are 0.5 to
/// 3.3 m/s^2 and 2.7 to 8.6 rad/s^2.
inline constexpr double kUsualAcceleration = 3, kUsualTurnAcceleration = 6;

/// Seconds after which nothing is known of the motion any more; a hand turns round in that time.
inline constexpr double kLongestPause = 0.3;

}  // namespace yorb

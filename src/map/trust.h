// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "map/map.h"

namespace yorb {

/// Of what was just born.
constexpr double kTrustInNew = 0.25;

/// How much a landmark of the map counts for a pose. Everyone who comes into view brings many at once, but none that
/// several keyframes saw standing still over two seconds: those count 1, and what they saw within a moment 0.6.
double TrustIn(const Landmark& landmark, const Map& map);

}  // namespace yorb

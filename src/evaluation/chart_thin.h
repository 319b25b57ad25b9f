// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "evaluation/svg.h"

namespace yorb {

/// Leaves out points of a line that no eye would miss. Where x never falls (a curve over time), each half pixel's
/// column keeps its first, lowest, highest and last point, so that peaks stay; otherwise (a path) points closer than a
/// fraction of a pixel to the one kept before go. The first and the last point stay.
std::vector<SvgPoint> ThinLine(const std::vector<SvgPoint>& points);

/// Leaves out dots that would stand on top of others, by a grid of half pixels.
std::vector<SvgPoint> ThinDots(const std::vector<SvgPoint>& points);

}  // namespace yorb

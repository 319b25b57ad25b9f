// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "core/time.h"
#include "geometry/trajectory.h"

namespace yorb {

/// The stamps of the colour pictures of a TUM-layout folder: of associations.txt where it is there, else of rgb.txt.
/// The pictures themselves are not looked for. Bad input where neither list is there, or a line has no stamp.
Result<std::vector<Timestamp>> ReadColourStamps(const std::string& folder);

/// The share of the pictures that have a pose within 20 ms, each pose counted once; 0 to 1. `offset` seconds are added
/// to the poses' stamps.
double CoverageOf(const std::vector<Timestamp>& pictures, const Trajectory& estimate, double offset = 0);

}  // namespace yorb

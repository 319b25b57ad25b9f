// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "camera/rig.h"

namespace yorb {

/// How much each of several points of a picture counts beside those around it, a row a point: 1 where few are near,
/// less where many share a small place, so that a place counts for a few points at most, however many are found there.
/// What lies close together moves together, and errs together: a hundred points on a shirt are no hundred witnesses.
std::vector<double> SharesOfPlaces(const std::vector<Eigen::Vector2f>& points_px, const Rig& rig);

}  // namespace yorb

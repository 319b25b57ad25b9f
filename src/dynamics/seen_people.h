// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "dynamics/body.h"

namespace yorb {

/// Whether a map of people (Detections::people) shows anybody at all.
bool ShowsSomebody(const cv::Mat& people);

/// Marks kBody what a map of people shows, surface by surface: cells of depth that hang together belong to one thing,
/// and that is somebody where the map says so of half of it. The map is coarse, and takes what is beside somebody for
/// him; a wall there is large, and stays out of it. Who stands behind somebody else in one box, or is too near for a
/// box, is found. What the mask knows already is left as it is.
CellMask WithSeenPeople(CellMask mask, const DepthCells& depth, const cv::Mat& people);

}  // namespace yorb

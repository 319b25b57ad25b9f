// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace yorb {

constexpr int kPeopleCellPx = 8;       ///< side of a cell of the map of people, in pixels of the network's input
constexpr float kUnlabelledCell = -1;  ///< the label of a cell of which nothing is learnt

/// What cells are to be called, from a mask of people (see `Scene`): the share of person among the known pixels, 0 to
/// 1, CV_32F; `kUnlabelledCell` where more than a quarter is unknown. The mask's sides are multiples of the cell's.
cv::Mat LabelCells(const cv::Mat& people_mask);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "detection/box.h"

namespace yorb {

/// The picture in colour with its boxes, their names and confidences drawn in; a class has the same colour everywhere.
cv::Mat DrawBoxes(const cv::Mat& picture, const std::vector<Box>& boxes);

}  // namespace yorb

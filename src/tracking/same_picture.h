// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "features/frame.h"

namespace yorb {

/// A frame, and its pixels (CV_8UC1) if they are at hand.
struct PictureOfFrame {
  const Frame& frame;
  const cv::Mat& grey;
};

/// Whether both are the very same picture: a driver hands it out again under a new time stamp. Pixels tell where both
/// have them, since which points are left out of a picture may differ from time to time; otherwise all points do. Never
/// where no points are: black pictures are all alike.
bool IsSamePicture(const PictureOfFrame& a, const PictureOfFrame& b);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "core/result.h"

namespace yorb {

/// The picture turned and mirrored as an EXIF orientation asks, so that it looks as in any viewer.
cv::Mat Upright(const cv::Mat& picture, int orientation);

/// A single picture as a viewer shows it: 8-bit, grey or BGR. Bad input where it is missing or cannot be read whole.
Result<cv::Mat> ReadUprightPicture(const std::string& path);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <string_view>

#include "core/result.h"

namespace yorb {

/// How the camera was held, as a JPEG or PNG says in its EXIF block: 1 (upright) to 8; 1 where nothing is said. The
/// beginning of the file is enough.
int ExifOrientation(std::string_view bytes);

/// The picture turned and mirrored as an EXIF orientation asks, so that it looks as in any viewer.
cv::Mat Upright(const cv::Mat& picture, int orientation);

/// A single picture as a viewer shows it: 8-bit, grey or BGR. Bad input where it is missing or cannot be read whole.
Result<cv::Mat> ReadUprightPicture(const std::string& path);

}  // namespace yorb

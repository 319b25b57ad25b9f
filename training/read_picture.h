// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "core/result.h"

namespace yorb {

/// A picture in colour (CV_8UC3, BGR), its longer side at most `long_side_px`.
Result<cv::Mat> ReadSmallPicture(const std::string& path, int long_side_px);

}  // namespace yorb

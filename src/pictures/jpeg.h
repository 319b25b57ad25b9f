// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "core/result.h"
#include "pictures/decoded_picture.h"

namespace yorb {

/// Decodes a JPEG to the very bits that OpenCV gives (CV_8UC1 or CV_8UC3), but notes what OpenCV only prints: that the
/// data made no sense from some place on, and that the rest of the picture is guessed. A few stray bytes at the end of
/// the data, as webcams leave them, are no damage. CMYK and 12 bits are uncommon.
DecodedPicture DecodeJpeg(const std::string& bytes);

/// An 8-bit picture with 1 or 3 (BGR) channels as the content of a JPEG file; quality is 1 to 100. Failure for any
/// other picture.
Result<std::string> EncodeJpeg(const cv::Mat& picture, int quality);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "core/result.h"
#include "pictures/decoded_picture.h"

namespace yorb {

/// Decodes a PNG of any kind to the bits that OpenCV gives: grey as 1 channel, colours as 3, with transparency (grey,
/// too) as 4; 8 bits, or 16 where the file has so many. Checksums of what makes the picture
/// that do not fit are damage.
DecodedPicture DecodePng(const std::string& bytes);

/// A picture of 8 or 16 bits with 1, 3 (BGR) or 4 (BGRA) channels as the content of a PNG file, compressed quickly.
/// Failure for any other.
Result<std::string> EncodePng(const cv::Mat& picture);

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace yorb {

/// What became of a JPEG.
struct JpegPicture {
  enum class Kind {
    kWhole,
    kDamaged,   ///< the decoder had to make something up
    kUncommon,  ///< of a kind that is left to OpenCV (CMYK, 12 bits)
  };
  Kind kind = Kind::kUncommon;
  cv::Mat pixels;  ///< CV_8UC1 or CV_8UC3 (BGR), the very bits that OpenCV gives; empty unless whole
};

/// Decodes a JPEG as OpenCV does, but notes what OpenCV only prints: that the data made no sense from some place on,
/// and that the rest of the picture is guessed. A few stray bytes at the end of the data, as webcams leave them, are no
/// damage.
JpegPicture DecodeJpeg(const std::string& bytes);

}  // namespace yorb

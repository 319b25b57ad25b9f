// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace yorb {

inline constexpr double kMostPixels = 1 << 28;  ///< of a picture; one with as many is left to others

/// What became of the bytes of a picture file.
struct DecodedPicture {
  enum class Kind {
    kWhole,
    kDamaged,   ///< the decoder had to make something up, or gave up
    kUncommon,  ///< of a kind that is left to others (pictures/other_formats.h)
  };
  Kind kind = Kind::kUncommon;
  cv::Mat pixels;  ///< as stored, colours in OpenCV's order (BGR, BGRA); empty unless whole
};

}  // namespace yorb

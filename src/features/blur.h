// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "features/grey_image.h"
#include "features/instructions.h"

namespace yorb {

/// The 7x7 Gaussian of sigma 2 through which ORB reads its descriptors, the picture mirrored at its border without
/// repeating the edge. Equal to the bit to what OpenCV 4.6 does within cv::ORB: 32-bit floats, fused multiply-adds from
/// left to right, then from the middle row outwards, rounded once at the end.
class Blur {
 public:
  /// The result lives until the next call.
  GreyView Apply(const GreyView& source, Instructions instructions);

 private:
  void BlurRow(const GreyView& source, int y, Instructions instructions);

  GreyImage target_;
  std::vector<float> mirrored_;  ///< one row with mirrored pixels at each end
  std::vector<float> rows_[7];   ///< the last seven rows, blurred along x
};

}  // namespace yorb

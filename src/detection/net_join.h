// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <vector>

#include "detection/net_program.h"

namespace yorb {

/// A picture, and by how much it is to be enlarged still.
struct NetPart {
  NetValue picture;
  int64_t by_y = 1, by_x = 1;

  bool IsEnlarged() const { return by_y * by_x > 1; }
};

/// The shape of the picture that is made of parts beside each other; an error where they do not fit.
Result<std::vector<int64_t>> JoinedDims(const std::vector<NetPart>& parts);

/// Enlargements, and what puts them beside other pictures, that need not be made: their only readers are convolutions
/// of single pixels, which give the same where they convolve the small picture and their result is enlarged, for a
/// quarter of the multiplications. The necks of YOLO networks are such.
std::set<const OnnxNode*> NodesToPutOff(const OnnxModel& model);

/// A convolution of single pixels, of parts that fit. One of them is not to be enlarged.
NetOutputs AddConvolutionOfParts(const NetNode& node, const std::vector<NetPart>& parts);

}  // namespace yorb

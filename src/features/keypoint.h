// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace yorb {

/// An oriented FAST corner.
struct Keypoint {
  float x = 0, y = 0;   ///< pixels of the full picture, distorted as the picture is
  float angle_rad = 0;  ///< by the intensity centroid, in [0, 2 pi)
  float response = 0;   ///< strength of the corner, comparable within one picture
  int octave = 0;       ///< pyramid level; 0 is the picture itself
};

/// 256 bits of rotated BRIEF, equal to the bit to OpenCV's ORB: byte i of its row is byte i of this memory.
using Descriptor = std::array<uint64_t, 4>;

/// What the extractor finds in one picture; rows of both belong together.
struct Features {
  std::vector<Keypoint> keypoints;
  std::vector<Descriptor> descriptors;
};

}  // namespace yorb

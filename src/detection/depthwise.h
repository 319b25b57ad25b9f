// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace yorb {

/// A convolution of each channel by itself, channels next to each other in memory.
struct DepthwiseSize {
  int64_t height = 0, width = 0, channels = 0;  ///< of the picture
  int64_t pixel_step = 0;                       ///< floats between its pixels
  int64_t out_height = 0, out_width = 0;
  int64_t kernel = 0, stride = 0;  ///< px, along both axes
  int64_t top = 0, left = 0;       ///< padding, px
};

/// Whether the processor has the instructions, the kernel and its stride are among those that are made (3 or 5 px, by 1
/// or 2), and the picture is small enough to gain by it.
bool IsForDepthwise(const DepthwiseSize& size);

/// One such convolution with its weights. Sixteen channels at a time are laid out with their padding, so that no pixel
/// is at an edge. Not for several threads at once.
class Depthwise {
 public:
  /// `weights`: (channels, kernel, kernel); `bias`: one a channel, or none. `least`, `most`: limits of what is given.
  Depthwise(const DepthwiseSize& size, const std::vector<float>& weights, const std::vector<float>& bias, float least,
            float most);

  void Run(const float* picture, float* to);

 private:
  DepthwiseSize size_;
  float least_, most_;
  std::vector<float> weights_;  ///< (groups of sixteen, kernel, kernel, 16)
  std::vector<float> bias_;     ///< (groups of sixteen, 16)
  std::vector<float> padded_;   ///< (height, width, 16) of one group
};

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace yorb {

/// A picture to wrap around things: repeats without end, and is filtered over the area that a pixel sees, so that what
/// is rendered does not alias.
class Texture {
 public:
  /// From an 8-bit BGR picture whose sides are powers of two.
  explicit Texture(const cv::Mat& bgr);

  /// Mean colour (B, G, R in 0..255) around `uv`, where one texture spans 1 x 1, over the parallelogram that one step
  /// to the right and one step down in the picture span on the texture.
  Eigen::Array3f Sample(const Eigen::Vector2f& uv, const Eigen::Vector2f& right_step,
                        const Eigen::Vector2f& down_step) const;

  int width() const { return levels_.front().width; }
  int height() const { return levels_.front().height; }

 private:
  struct Level {
    int width = 0, height = 0;     // powers of two
    std::vector<uint32_t> texels;  // 0x00RRGGBB
  };

  static Eigen::Array3f Bilinear(const Level& level, float u, float v);
  Eigen::Array3f Trilinear(float u, float v, float lod) const;

  std::vector<Level> levels_;  // from full size down to 1 x 1
};

}  // namespace yorb

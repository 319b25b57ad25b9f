// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic/texture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/check.h"

namespace yorb {
namespace {

constexpr int kMaxTaps = 6;  // along the longer side of a stretched footprint

bool IsPowerOfTwo(int n) { return n > 0 && (n & (n - 1)) == 0; }

// Four bytes of one word to four 16-bit lanes, so that one multiplication weighs all channels.
uint64_t Spread(uint32_t texel) {
  uint64_t lanes = texel;
  lanes = (lanes | lanes << 16) & 0x0000ffff0000ffffull;
  return (lanes | lanes << 8) & 0x00ff00ff00ff00ffull;
}

int Floor(float x) {
  const int whole = static_cast<int>(x);
  return whole - (x < static_cast<float>(whole) ? 1 : 0);
}

}  // namespace

Texture::Texture(const cv::Mat& bgr) {
  YORB_CHECK(bgr.type() == CV_8UC3 && IsPowerOfTwo(bgr.cols) && IsPowerOfTwo(bgr.rows),
             "a texture's sides are powers of two");
  cv::Mat picture = bgr;
  while (true) {
    Level level{picture.cols, picture.rows, {}};
    level.texels.reserve(static_cast<size_t>(picture.cols) * picture.rows);
    for (int y = 0; y < picture.rows; ++y) {
      for (int x = 0; x < picture.cols; ++x) {
        const cv::Vec3b& c = picture.at<cv::Vec3b>(y, x);
        level.texels.push_back(static_cast<uint32_t>(c[0]) | static_cast<uint32_t>(c[1]) << 8 |
                               static_cast<uint32_t>(c[2]) << 16);
      }
    }
    levels_.push_back(std::move(level));
    if (picture.cols == 1 && picture.rows == 1) return;
    cv::Mat half;
    cv::resize(picture, half, {std::max(1, picture.cols / 2), std::max(1, picture.rows / 2)}, 0, 0, cv::INTER_AREA);
    picture = half;
  }
}

Eigen::Array3f Texture::Bilinear(const Level& level, float u, float v) {
  const float x = u * static_cast<float>(level.width) - 0.5f, y = v * static_cast<float>(level.height) - 0.5f;
  const int left = Floor(x), top = Floor(y);
  const auto right_weight = static_cast<uint64_t>((x - static_cast<float>(left)) * 256.f);
  const auto bottom_weight = static_cast<uint64_t>((y - static_cast<float>(top)) * 256.f);
  const size_t x0 = left & (level.width - 1), x1 = (left + 1) & (level.width - 1);
  const uint32_t* upper = level.texels.data() + static_cast<size_t>(top & (level.height - 1)) * level.width;
  const uint32_t* lower = level.texels.data() + static_cast<size_t>((top + 1) & (level.height - 1)) * level.width;
  const uint64_t both = right_weight * bottom_weight >> 8;  // the four weights add up to 256: lanes stay below 2^16
  const uint64_t sum = Spread(upper[x0]) * (256 - right_weight - bottom_weight + both) +
                       Spread(upper[x1]) * (right_weight - both) + Spread(lower[x0]) * (bottom_weight - both) +
                       Spread(lower[x1]) * both;
  return Eigen::Array3f(static_cast<float>(sum & 0xffff), static_cast<float>(sum >> 16 & 0xffff),
                        static_cast<float>(sum >> 32 & 0xffff)) *
         (1.f / 256.f);
}

Eigen::Array3f Texture::Trilinear(float u, float v, float lod) const {
  const float last = static_cast<float>(levels_.size() - 1);
  if (lod <= 0) return Bilinear(levels_.front(), u, v);
  if (lod >= last) return Bilinear(levels_.back(), u, v);
  const auto finer = static_cast<size_t>(lod);
  const float blend = lod - static_cast<float>(finer);
  return Bilinear(levels_[finer], u, v) * (1.f - blend) + Bilinear(levels_[finer + 1], u, v) * blend;
}

Eigen::Array3f Texture::Sample(const Eigen::Vector2f& uv, const Eigen::Vector2f& right_step,
                               const Eigen::Vector2f& down_step) const {
  const Eigen::Array2f size(static_cast<float>(width()), static_cast<float>(height()));
  const Eigen::Vector2f right = (right_step.array() * size).matrix(), down = (down_step.array() * size).matrix();
  const float right_length = right.norm(), down_length = down.norm();
  const float longer = std::max({right_length, down_length, 1e-6f});
  const float shorter = std::max(std::abs(right.x() * down.y() - right.y() * down.x()) / longer, 1e-6f);
  // As many taps along the longer side as it takes to cover it with squares of the shorter side.
  const int num_taps =
      longer <= 1.f ? 1 : std::clamp(static_cast<int>(longer / std::max(shorter, 1.f) + 0.5f), 1, kMaxTaps);
  const float lod = std::log2(std::max(longer / static_cast<float>(num_taps), shorter));
  if (num_taps == 1) return Trilinear(uv.x(), uv.y(), lod);
  const Eigen::Vector2f& axis = right_length > down_length ? right_step : down_step;
  Eigen::Array3f sum = Eigen::Array3f::Zero();
  for (int i = 0; i < num_taps; ++i) {
    const float along = (static_cast<float>(i) + 0.5f) / static_cast<float>(num_taps) - 0.5f;
    sum += Trilinear(uv.x() + along * axis.x(), uv.y() + along * axis.y(), lod);
  }
  return sum / static_cast<float>(num_taps);
}

}  // namespace yorb

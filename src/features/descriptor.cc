// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/descriptor.h"

#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>

#include "features/orb_pattern.h"

namespace yorb {
namespace {

constexpr int kPatchRadius = 15;
/// Half the width of the round patch in the row `v` above or below its centre; symmetric about the diagonals.
constexpr int kHalfWidth[kPatchRadius + 1] = {15, 15, 15, 15, 14, 14, 14, 13, 13, 12, 11, 10, 9, 8, 6, 3};
constexpr float kRadiansPerDegree = static_cast<float>(CV_PI / 180.f);

struct Moments {
  int x = 0, y = 0;
};

Moments MomentsOf(const GreyView& level, int x, int y) {
  Moments sum;
  for (int v = -kPatchRadius; v <= kPatchRadius; ++v) {
    const uint8_t* row = level.Row(y + v) + x;
    const int half_width = kHalfWidth[std::abs(v)];
    for (int u = -half_width; u <= half_width; ++u) {
      sum.x += u * row[u];
      sum.y += v * row[u];
    }
  }
  return sum;
}

}  // namespace

float OrientationOf(const GreyView& level, int x, int y, Instructions) {
  const Moments moments = MomentsOf(level, x, y);
  const float degrees = cv::fastAtan2(static_cast<float>(moments.y), static_cast<float>(moments.x));
  return degrees < 360 ? degrees * kRadiansPerDegree : 0.f;
}

Descriptor DescribeAt(const GreyView& blurred, int x, int y, float angle_rad, Instructions) {
  const float a = std::cos(angle_rad), b = std::sin(angle_rad);
  const uint8_t* centre = blurred.Row(y) + x;
  const auto pixel = [&](float px, float py) {
    const ptrdiff_t u = std::lrint(px * a - py * b), v = std::lrint(px * b + py * a);
    return centre[v * blurred.stride + u];
  };
  Descriptor descriptor{};
  for (size_t i = 0; i < kOrbPairs.size(); ++i) {
    const OrbPair& pair = kOrbPairs[i];
    const bool is_darker = pixel(pair.x1, pair.y1) < pixel(pair.x2, pair.y2);
    descriptor[i / 64] |= static_cast<uint64_t>(is_darker) << (i % 64);
  }
  return descriptor;
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/descriptor.h"

#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>

#include "features/descriptor_rows.h"
#include "features/orb_pattern.h"

namespace yorb {
namespace descriptor {

Moments MomentsPortable(const uint8_t* centre, ptrdiff_t stride) {
  Moments sum;
  for (int v = -kPatchRadius; v <= kPatchRadius; ++v) {
    const uint8_t* row = centre + v * stride;
    const int half_width = kHalfWidth[std::abs(v)];
    int row_sum = 0;
    for (int u = -half_width; u <= half_width; ++u) {
      sum.x += u * row[u];
      row_sum += row[u];
    }
    sum.y += v * row_sum;
  }
  return sum;
}

namespace {

/// To the nearest whole number, half to even: beyond 1.5 * 2^23 floats are whole numbers.
int Round(float value) {
  constexpr float kWhole = 12582912.f;
  return static_cast<int>(value + kWhole) - static_cast<int>(kWhole);
}

}  // namespace

void TurnPortable(float cosine, float sine, int stride, Offsets& offsets) {
  for (size_t i = 0; i < kOrbPairs.size(); ++i) {
    const OrbPair& pair = kOrbPairs[i];
    const auto offset = [&](float x, float y) {
      const float u = x * cosine - y * sine, v = x * sine + y * cosine;
      return Round(v) * stride + Round(u);
    };
    offsets.first[i] = offset(pair.x1, pair.y1);
    offsets.second[i] = offset(pair.x2, pair.y2);
  }
}

}  // namespace descriptor

namespace {

constexpr float kRadiansPerDegree = static_cast<float>(CV_PI / 180.f);

/// Bit i: is the first pixel of pair i darker? From the last bit to the first, so that each step is a shift.
uint64_t CompareSixtyFour(const uint8_t* centre, const int32_t* first, const int32_t* second) {
  uint64_t bits = 0;
  for (int i = 63; i >= 0; --i) bits = bits + bits + (centre[first[i]] < centre[second[i]]);
  return bits;
}

}  // namespace

float OrientationOf(const GreyView& level, int x, int y, Instructions instructions) {
  const auto moments_of = instructions == Instructions::kAvx2 ? descriptor::MomentsAvx2 : descriptor::MomentsPortable;
  const descriptor::Moments moments = moments_of(level.Row(y) + x, level.stride);
  const float degrees = cv::fastAtan2(static_cast<float>(moments.y), static_cast<float>(moments.x));
  return degrees < 360 ? degrees * kRadiansPerDegree : 0.f;
}

Descriptor DescribeAt(const GreyView& blurred, int x, int y, float angle_rad, Instructions instructions) {
  descriptor::Offsets offsets;
  const auto turn = instructions == Instructions::kAvx2 ? descriptor::TurnAvx2 : descriptor::TurnPortable;
  turn(std::cos(angle_rad), std::sin(angle_rad), static_cast<int>(blurred.stride), offsets);
  const uint8_t* centre = blurred.Row(y) + x;
  Descriptor result;
  for (size_t word = 0; word < result.size(); ++word) {
    result[word] = CompareSixtyFour(centre, offsets.first + 64 * word, offsets.second + 64 * word);
  }
  return result;
}

}  // namespace yorb

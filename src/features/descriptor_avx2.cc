// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/descriptor_rows.h"
#include "features/instructions.h"

#if defined(YORB_AVX2)
#include <immintrin.h>

#include "features/orb_pattern.h"

namespace yorb::descriptor {
namespace {

constexpr int kRows = 2 * kPatchRadius + 1;

/// Weights of the 32 bytes that start 15 pixels left of the centre, for each row of the patch; 0 outside of the circle.
struct MomentWeights {
  alignas(32) int8_t x[kRows][32] = {};
  alignas(32) int8_t y[kRows][32] = {};

  constexpr MomentWeights() {
    for (int v = -kPatchRadius; v <= kPatchRadius; ++v) {
      const int half_width = kHalfWidth[v < 0 ? -v : v];
      for (int u = -half_width; u <= half_width; ++u) {
        x[v + kPatchRadius][u + kPatchRadius] = static_cast<int8_t>(u);
        y[v + kPatchRadius][u + kPatchRadius] = static_cast<int8_t>(v);
      }
    }
  }
};
constexpr MomentWeights kMoments;

/// The pattern as floats, coordinate by coordinate.
struct PatternFloats {
  alignas(32) float x1[256] = {}, y1[256] = {}, x2[256] = {}, y2[256] = {};

  PatternFloats() {
    for (int i = 0; i < 256; ++i) {
      const OrbPair& pair = kOrbPairs[static_cast<size_t>(i)];
      x1[i] = pair.x1, y1[i] = pair.y1, x2[i] = pair.x2, y2[i] = pair.y2;
    }
  }
};

const PatternFloats& Pattern() {
  static const PatternFloats pattern;
  return pattern;
}

YORB_AVX2 inline __m256i Weighted(__m256i pixels, const int8_t* weights) {
  return _mm256_maddubs_epi16(pixels, _mm256_load_si256(reinterpret_cast<const __m256i*>(weights)));
}

YORB_AVX2 inline int SumOf(__m256i lanes) {
  __m128i sum = _mm_add_epi32(_mm256_castsi256_si128(lanes), _mm256_extracti128_si256(lanes, 1));
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0x4e));
  return _mm_cvtsi128_si32(sum) + _mm_extract_epi32(sum, 1);
}

struct Turn {
  __m256 cosine, sine;
  __m256i stride;
};

YORB_AVX2 inline void TurnEight(const float* xs, const float* ys, const Turn& turn, int32_t* offsets) {
  const __m256 x = _mm256_load_ps(xs), y = _mm256_load_ps(ys);
  const __m256 u = _mm256_sub_ps(_mm256_mul_ps(x, turn.cosine), _mm256_mul_ps(y, turn.sine));
  const __m256 v = _mm256_add_ps(_mm256_mul_ps(x, turn.sine), _mm256_mul_ps(y, turn.cosine));
  const __m256i rows = _mm256_mullo_epi32(_mm256_cvtps_epi32(v), turn.stride);
  _mm256_store_si256(reinterpret_cast<__m256i*>(offsets), _mm256_add_epi32(rows, _mm256_cvtps_epi32(u)));
}

}  // namespace

YORB_AVX2 Moments MomentsAvx2(const uint8_t* centre, ptrdiff_t stride) {
  const __m256i ones = _mm256_set1_epi16(1);
  __m256i sum_x = _mm256_setzero_si256(), sum_y = sum_x;
  const uint8_t* row = centre - kPatchRadius * stride - kPatchRadius;
  // Four rows at a time fit into 16 bits: 4 * 2 * 255 * 15 < 2^15.
  for (int v = 0; v < kRows;) {
    __m256i part_x = _mm256_setzero_si256(), part_y = part_x;
    for (int i = 0; i < 4 && v < kRows; ++i, ++v, row += stride) {
      const __m256i pixels = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(row));
      part_x = _mm256_add_epi16(part_x, Weighted(pixels, kMoments.x[v]));
      part_y = _mm256_add_epi16(part_y, Weighted(pixels, kMoments.y[v]));
    }
    sum_x = _mm256_add_epi32(sum_x, _mm256_madd_epi16(part_x, ones));
    sum_y = _mm256_add_epi32(sum_y, _mm256_madd_epi16(part_y, ones));
  }
  return {SumOf(sum_x), SumOf(sum_y)};
}

YORB_AVX2 void TurnAvx2(float cosine, float sine, int stride, Offsets& offsets) {
  const PatternFloats& pattern = Pattern();
  const Turn turn{_mm256_set1_ps(cosine), _mm256_set1_ps(sine), _mm256_set1_epi32(stride)};
  for (int i = 0; i < 256; i += 8) {
    TurnEight(pattern.x1 + i, pattern.y1 + i, turn, offsets.first + i);
    TurnEight(pattern.x2 + i, pattern.y2 + i, turn, offsets.second + i);
  }
}

}  // namespace yorb::descriptor

#else

namespace yorb::descriptor {
Moments MomentsAvx2(const uint8_t* centre, ptrdiff_t stride) { return MomentsPortable(centre, stride); }
void TurnAvx2(float cosine, float sine, int stride, Offsets& offsets) { TurnPortable(cosine, sine, stride, offsets); }
}  // namespace yorb::descriptor
#endif

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/blur_rows.h"
#include "features/instructions.h"

#if defined(YORB_AVX2)
#include <immintrin.h>

namespace yorb::blur {
namespace {

constexpr int kLanes = 8;

/// Seven rows at x, weighted from the middle outwards, as whole numbers.
YORB_AVX2 inline __m256i ColumnAt(const float* const rows[7], int x) {
  __m256 sum = _mm256_mul_ps(_mm256_set1_ps(kWeights[3]), _mm256_loadu_ps(rows[3] + x));
  for (int i = 1; i <= kRadius; ++i) {
    const __m256 pair = _mm256_add_ps(_mm256_loadu_ps(rows[3 + i] + x), _mm256_loadu_ps(rows[3 - i] + x));
    sum = _mm256_fmadd_ps(_mm256_set1_ps(kWeights[3 + i]), pair, sum);
  }
  return _mm256_cvtps_epi32(sum);
}

}  // namespace

YORB_AVX2 void WidenAvx2(const uint8_t* row, int width, float* out) {
  for (int x = 0; x < width; x += kLanes) {
    const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(row + x));
    _mm256_storeu_ps(out + x, _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(bytes)));
  }
}

YORB_AVX2 void RowAvx2(const float* mirrored, int width, float* out) {
  for (int x = 0; x < width; x += 2 * kLanes) {
    __m256 a = _mm256_mul_ps(_mm256_set1_ps(kWeights[0]), _mm256_loadu_ps(mirrored + x));
    __m256 b = _mm256_mul_ps(_mm256_set1_ps(kWeights[0]), _mm256_loadu_ps(mirrored + x + kLanes));
    for (int i = 1; i < 7; ++i) {
      const __m256 weight = _mm256_set1_ps(kWeights[i]);
      a = _mm256_fmadd_ps(weight, _mm256_loadu_ps(mirrored + x + i), a);
      b = _mm256_fmadd_ps(weight, _mm256_loadu_ps(mirrored + x + i + kLanes), b);
    }
    _mm256_storeu_ps(out + x, a);
    _mm256_storeu_ps(out + x + kLanes, b);
  }
}

YORB_AVX2 void ColumnAvx2(const float* const rows[7], int width, uint8_t* out) {
  const __m256i order = _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7);  // undoes what packing by halves does
  for (int x = 0; x < width; x += 4 * kLanes) {
    const __m256i low = _mm256_packs_epi32(ColumnAt(rows, x), ColumnAt(rows, x + kLanes));
    const __m256i high = _mm256_packs_epi32(ColumnAt(rows, x + 2 * kLanes), ColumnAt(rows, x + 3 * kLanes));
    const __m256i bytes = _mm256_permutevar8x32_epi32(_mm256_packus_epi16(low, high), order);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + x), bytes);
  }
}

}  // namespace yorb::blur

#else

namespace yorb::blur {
void WidenAvx2(const uint8_t* row, int width, float* out) { WidenPortable(row, width, out); }
void RowAvx2(const float* mirrored, int width, float* out) { RowPortable(mirrored, width, out); }
void ColumnAvx2(const float* const rows[7], int width, uint8_t* out) { ColumnPortable(rows, width, out); }
}  // namespace yorb::blur
#endif

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/instructions.h"
#include "features/pyramid_rows.h"

#if defined(YORB_AVX2)
#include <immintrin.h>

namespace yorb::resize {
namespace {

template <typename T>
YORB_AVX2 inline __m256i Load(const T* from) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}
template <typename T>
YORB_AVX2 inline __m128i LoadHalf(const T* from) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}

/// Sixteen pixels between two rows, as 16-bit grey levels.
YORB_AVX2 inline __m256i BetweenSixteen(const int16_t* upper, const int16_t* lower, __m256i weights) {
  // Each product is off by -32768 times its weight; the weights sum to 256. The rest is half of 65536, to round.
  const __m256i back = _mm256_set1_epi32(32768 * 256 + 32768);
  const __m256i a = Load(upper), b = Load(lower);
  const __m256i low = _mm256_madd_epi16(_mm256_unpacklo_epi16(a, b), weights);
  const __m256i high = _mm256_madd_epi16(_mm256_unpackhi_epi16(a, b), weights);
  return _mm256_packus_epi32(_mm256_srli_epi32(_mm256_add_epi32(low, back), 16),
                             _mm256_srli_epi32(_mm256_add_epi32(high, back), 16));
}

}  // namespace

YORB_AVX2 void RowAvx2(const uint8_t* source, const Taps& taps, int16_t* out) {
  const int* start = taps.start.data();
  const uint8_t *first_lane = taps.first_lane.data(), *second_lane = taps.second_lane.data();
  const int16_t* weight = taps.weight.data();
  const __m256i sign = _mm256_set1_epi16(-32768);
  for (int x = 0; x < taps.size; x += kBlock, start += 2, first_lane += 2 * kBlock, second_lane += 2 * kBlock) {
    const __m128i low = LoadHalf(source + start[0]), high = LoadHalf(source + start[1]);
    const __m256i bytes = _mm256_inserti128_si256(_mm256_castsi128_si256(low), high, 1);
    const __m256i first = _mm256_shuffle_epi8(bytes, Load(first_lane));
    const __m256i second = _mm256_shuffle_epi8(bytes, Load(second_lane));
    const __m256i step = _mm256_mullo_epi16(_mm256_sub_epi16(second, first), Load(weight + x));
    const __m256i value = _mm256_add_epi16(_mm256_slli_epi16(first, 8), step);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + x), _mm256_xor_si256(value, sign));
  }
}

YORB_AVX2 void BetweenAvx2(const int16_t* upper, const int16_t* lower, int weight, int width, uint8_t* out) {
  const __m256i weights = _mm256_set1_epi32((weight << 16) | (256 - weight));
  for (int x = 0; x < width; x += 2 * kBlock) {
    const __m256i a = BetweenSixteen(upper + x, lower + x, weights);
    const __m256i b = BetweenSixteen(upper + x + kBlock, lower + x + kBlock, weights);
    const __m256i bytes = _mm256_permute4x64_epi64(_mm256_packus_epi16(a, b), 0xd8);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + x), bytes);
  }
}

}  // namespace yorb::resize

#else

namespace yorb::resize {
void RowAvx2(const uint8_t* source, const Taps& taps, int16_t* out) { RowPortable(source, taps, out); }
void BetweenAvx2(const int16_t* upper, const int16_t* lower, int weight, int width, uint8_t* out) {
  BetweenPortable(upper, lower, weight, width, out);
}
}  // namespace yorb::resize
#endif

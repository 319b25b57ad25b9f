// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/sigmoid.h"

#include <algorithm>
#include <cmath>

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define YORB_SIGMOID_AVX2 __attribute__((target("avx2,fma")))
#endif

namespace yorb {
namespace {

float OneSigmoid(float x) { return 1.f / (1.f + std::exp(-x)); }

#if defined(YORB_SIGMOID_AVX2)

/// exp(x) for x <= 0, by 2^n times a polynomial of degree 6 over half an octave to both sides (Taylor; error below
/// 2e-7 of the value).
YORB_SIGMOID_AVX2 inline __m256 ExpOfNegative(__m256 x) {
  const __m256 least = _mm256_set1_ps(-87.f);  // beyond, floats have no normal value
  x = _mm256_max_ps(x, least);
  const __m256 n =
      _mm256_round_ps(_mm256_mul_ps(x, _mm256_set1_ps(1.44269504f)), _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
  __m256 r = _mm256_fnmadd_ps(n, _mm256_set1_ps(0.693359375f), x);  // ln 2 in two parts
  r = _mm256_fnmadd_ps(n, _mm256_set1_ps(-2.12194440e-4f), r);
  __m256 p = _mm256_set1_ps(1.f / 720);
  for (const float c : {1.f / 120, 1.f / 24, 1.f / 6, 1.f / 2, 1.f, 1.f}) p = _mm256_fmadd_ps(p, r, _mm256_set1_ps(c));
  const __m256i exponent = _mm256_slli_epi32(_mm256_add_epi32(_mm256_cvtps_epi32(n), _mm256_set1_epi32(127)), 23);
  return _mm256_mul_ps(p, _mm256_castsi256_ps(exponent));
}

YORB_SIGMOID_AVX2 inline __m256 Sigmoid8(__m256 x) {
  const __m256 sign = _mm256_set1_ps(-0.f), one = _mm256_set1_ps(1.f);
  const __m256 e = ExpOfNegative(_mm256_or_ps(x, sign));         // exp(-|x|)
  const __m256 small = _mm256_div_ps(e, _mm256_add_ps(one, e));  // sigmoid(-|x|)
  return _mm256_blendv_ps(_mm256_sub_ps(one, small), small, x);  // by the sign of x
}

template <bool kTimesX>
YORB_SIGMOID_AVX2 size_t SigmoidsAvx2(const float* from, float* to, size_t count) {
  size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    const __m256 x = _mm256_loadu_ps(from + i);
    const __m256 s = Sigmoid8(x);
    _mm256_storeu_ps(to + i, kTimesX ? _mm256_mul_ps(x, s) : s);
  }
  return i;
}

bool HasAvx2() {
  static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return has;
}

#endif

/// How many numbers the vector kernel has done, from the first.
template <bool kTimesX>
size_t DoneByVectors(const float* from, float* to, size_t count) {
#if defined(YORB_SIGMOID_AVX2)
  if (HasAvx2()) return SigmoidsAvx2<kTimesX>(from, to, count);
#endif
  (void)from, (void)to, (void)count;
  return 0;
}

}  // namespace

void Sigmoids(const float* from, float* to, size_t count) {
  for (size_t i = DoneByVectors<false>(from, to, count); i < count; ++i) to[i] = OneSigmoid(from[i]);
}

void Silus(const float* from, float* to, size_t count) {
  for (size_t i = DoneByVectors<true>(from, to, count); i < count; ++i) to[i] = from[i] * OneSigmoid(from[i]);
}

void HardSwishes(const float* from, float* to, size_t count) {
  for (size_t i = 0; i < count; ++i) to[i] = from[i] * std::min(std::max(from[i] * (1.f / 6) + 0.5f, 0.f), 1.f);
}

}  // namespace yorb

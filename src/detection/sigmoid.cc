// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/sigmoid.h"

#include <algorithm>
#include <cmath>

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // a false alarm of gcc 12 within its own AVX-512 header
#endif
#define YORB_ACTIVATION_AVX2 __attribute__((target("avx2,fma")))
#define YORB_ACTIVATION_AVX512 __attribute__((target("avx512f")))
#endif

namespace yorb {
namespace {

float OneSigmoid(float x) { return 1.f / (1.f + std::exp(-x)); }

enum class Kind { kSigmoid, kSilu, kHardSwish };

template <Kind kKind>
float One(float x) {
  if constexpr (kKind == Kind::kSigmoid) return OneSigmoid(x);
  if constexpr (kKind == Kind::kSilu) return x * OneSigmoid(x);
  return x * std::min(std::max(x * (1.f / 6) + 0.5f, 0.f), 1.f);
}

#if defined(YORB_ACTIVATION_AVX2)

// exp(x) is 2^n times a polynomial of degree 6 over half an octave to both sides (Taylor; its error is below 2e-7 of
// the value). ln 2 is taken away in two parts.
constexpr float kLog2E = 1.44269504f, kLn2High = 0.693359375f, kLn2Low = -2.12194440e-4f;
constexpr float kTaylor[] = {1.f / 720, 1.f / 120, 1.f / 24, 1.f / 6, 1.f / 2, 1.f, 1.f};
constexpr int kRound = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;

/// exp(x) for x <= 0.
YORB_ACTIVATION_AVX2 inline __m256 ExpOfNegative(__m256 x) {
  x = _mm256_max_ps(x, _mm256_set1_ps(-87.f));  // beyond, floats have no normal value
  const __m256 n = _mm256_round_ps(_mm256_mul_ps(x, _mm256_set1_ps(kLog2E)), kRound);
  __m256 r = _mm256_fnmadd_ps(n, _mm256_set1_ps(kLn2High), x);
  r = _mm256_fnmadd_ps(n, _mm256_set1_ps(kLn2Low), r);
  __m256 p = _mm256_set1_ps(kTaylor[0]);
  for (int i = 1; i < 7; ++i) p = _mm256_fmadd_ps(p, r, _mm256_set1_ps(kTaylor[i]));
  const __m256i exponent = _mm256_slli_epi32(_mm256_add_epi32(_mm256_cvtps_epi32(n), _mm256_set1_epi32(127)), 23);
  return _mm256_mul_ps(p, _mm256_castsi256_ps(exponent));
}

YORB_ACTIVATION_AVX2 inline __m256 Sigmoid(__m256 x) {
  const __m256 one = _mm256_set1_ps(1.f);
  const __m256 e = ExpOfNegative(_mm256_or_ps(x, _mm256_set1_ps(-0.f)));  // exp(-|x|)
  const __m256 small = _mm256_div_ps(e, _mm256_add_ps(one, e));           // sigmoid(-|x|)
  return _mm256_blendv_ps(_mm256_sub_ps(one, small), small, x);           // by the sign of x
}

template <Kind kKind>
YORB_ACTIVATION_AVX2 inline __m256 Eight(__m256 x) {
  if constexpr (kKind == Kind::kSigmoid) return Sigmoid(x);
  if constexpr (kKind == Kind::kSilu) return _mm256_mul_ps(x, Sigmoid(x));
  const __m256 gate = _mm256_fmadd_ps(x, _mm256_set1_ps(1.f / 6), _mm256_set1_ps(0.5f));
  return _mm256_mul_ps(x, _mm256_min_ps(_mm256_max_ps(gate, _mm256_setzero_ps()), _mm256_set1_ps(1.f)));
}

/// How many numbers were done, from the first; so for all that follow.
template <Kind kKind>
YORB_ACTIVATION_AVX2 size_t ByEights(const float* from, float* to, size_t count) {
  size_t i = 0;
  for (; i + 8 <= count; i += 8) _mm256_storeu_ps(to + i, Eight<kKind>(_mm256_loadu_ps(from + i)));
  return i;
}

YORB_ACTIVATION_AVX512 inline __m512 Sigmoid(__m512 x) {
  const __m512 one = _mm512_set1_ps(1.f);
  const __m512 clipped = _mm512_min_ps(_mm512_max_ps(x, _mm512_set1_ps(-87.f)), _mm512_set1_ps(87.f));
  const __m512 minus = _mm512_sub_ps(_mm512_setzero_ps(), clipped);
  const __m512 n = _mm512_roundscale_ps(_mm512_mul_ps(minus, _mm512_set1_ps(kLog2E)), kRound);
  __m512 r = _mm512_fnmadd_ps(n, _mm512_set1_ps(kLn2High), minus);
  r = _mm512_fnmadd_ps(n, _mm512_set1_ps(kLn2Low), r);
  __m512 p = _mm512_set1_ps(kTaylor[0]);
  for (int i = 1; i < 7; ++i) p = _mm512_fmadd_ps(p, r, _mm512_set1_ps(kTaylor[i]));
  const __m512 sum = _mm512_add_ps(one, _mm512_scalef_ps(p, n));
  const __m512 guess = _mm512_rcp14_ps(sum);  // 14 bits; one step of Newton's makes 24 of them
  return _mm512_mul_ps(guess, _mm512_fnmadd_ps(sum, guess, _mm512_set1_ps(2.f)));
}

template <Kind kKind>
YORB_ACTIVATION_AVX512 inline __m512 Sixteen(__m512 x) {
  if constexpr (kKind == Kind::kSigmoid) return Sigmoid(x);
  if constexpr (kKind == Kind::kSilu) return _mm512_mul_ps(x, Sigmoid(x));
  const __m512 gate = _mm512_fmadd_ps(x, _mm512_set1_ps(1.f / 6), _mm512_set1_ps(0.5f));
  return _mm512_mul_ps(x, _mm512_min_ps(_mm512_max_ps(gate, _mm512_setzero_ps()), _mm512_set1_ps(1.f)));
}

template <Kind kKind>
YORB_ACTIVATION_AVX512 size_t BySixteens(const float* from, float* to, size_t count) {
  size_t i = 0;
  for (; i + 16 <= count; i += 16) _mm512_storeu_ps(to + i, Sixteen<kKind>(_mm512_loadu_ps(from + i)));
  return i;
}

#endif

template <Kind kKind>
size_t DoneByVectors(const float* from, float* to, size_t count) {
#if defined(YORB_ACTIVATION_AVX2)
  if (__builtin_cpu_supports("avx512f")) return BySixteens<kKind>(from, to, count);
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return ByEights<kKind>(from, to, count);
#endif
  (void)from, (void)to, (void)count;
  return 0;
}

template <Kind kKind>
void Apply(const float* from, float* to, size_t count) {
  for (size_t i = DoneByVectors<kKind>(from, to, count); i < count; ++i) to[i] = One<kKind>(from[i]);
}

}  // namespace

void Sigmoids(const float* from, float* to, size_t count) { Apply<Kind::kSigmoid>(from, to, count); }

void Silus(const float* from, float* to, size_t count) { Apply<Kind::kSilu>(from, to, count); }

void HardSwishes(const float* from, float* to, size_t count) { Apply<Kind::kHardSwish>(from, to, count); }

}  // namespace yorb

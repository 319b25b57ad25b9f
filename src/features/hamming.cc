// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/hamming.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace yorb {
namespace hamming {

void Portable(const Descriptor& query, const Descriptor* rows, size_t count, uint16_t* distances) {
  for (size_t i = 0; i < count; ++i) distances[i] = static_cast<uint16_t>(HammingDistance(query, rows[i]));
}

#if defined(__x86_64__)
namespace {

/// Counts bits by nibbles with a table in a register, then sums bytes: Mula's method.
__attribute__((target("avx2"))) void WithAvx2(const Descriptor& query, const Descriptor* rows, size_t count,
                                              uint16_t* distances) {
  const __m256i table =
      _mm256_setr_epi8(0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4, 0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4);
  const __m256i nibble = _mm256_set1_epi8(15);
  const __m256i wanted = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(query.data()));
  for (size_t i = 0; i < count; ++i) {
    const __m256i row = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(rows[i].data()));
    const __m256i differ = _mm256_xor_si256(wanted, row);
    const __m256i low = _mm256_shuffle_epi8(table, _mm256_and_si256(differ, nibble));
    const __m256i high = _mm256_shuffle_epi8(table, _mm256_and_si256(_mm256_srli_epi16(differ, 4), nibble));
    const __m256i sums = _mm256_sad_epu8(_mm256_add_epi8(low, high), _mm256_setzero_si256());
    const __m128i halves = _mm_add_epi64(_mm256_castsi256_si128(sums), _mm256_extracti128_si256(sums, 1));
    distances[i] = static_cast<uint16_t>(_mm_cvtsi128_si32(halves) + _mm_extract_epi32(halves, 2));
  }
}

__attribute__((target("avx512f,avx512vl,avx512vpopcntdq"))) void WithAvx512(const Descriptor& query,
                                                                            const Descriptor* rows, size_t count,
                                                                            uint16_t* distances) {
  const __m256i wanted = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(query.data()));
  for (size_t i = 0; i < count; ++i) {
    const __m256i row = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(rows[i].data()));
    const __m256i counts = _mm256_popcnt_epi64(_mm256_xor_si256(wanted, row));
    const __m128i halves = _mm_add_epi64(_mm256_castsi256_si128(counts), _mm256_extracti128_si256(counts, 1));
    distances[i] = static_cast<uint16_t>(_mm_cvtsi128_si32(halves) + _mm_extract_epi32(halves, 2));
  }
}

}  // namespace

Path Avx2() { return __builtin_cpu_supports("avx2") ? WithAvx2 : nullptr; }
Path Avx512() {
  const bool can = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                   __builtin_cpu_supports("avx512vpopcntdq");
  return can ? WithAvx512 : nullptr;
}
#else
Path Avx2() { return nullptr; }
Path Avx512() { return nullptr; }
#endif

}  // namespace hamming

namespace {

hamming::Path BestPath() {
  if (const hamming::Path path = hamming::Avx512()) return path;
  return hamming::Portable;  // measured faster than AVX2 where the processor has popcnt
}

}  // namespace

void HammingDistances(const Descriptor& query, const Descriptor* rows, size_t count, uint16_t* distances) {
  static const hamming::Path path = BestPath();
  path(query, rows, count, distances);
}

}  // namespace yorb

// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "features/fast_rows.h"
#include "features/instructions.h"

#if defined(YORB_AVX2)
#include <immintrin.h>

namespace yorb::fast {
namespace {

using Bytes = __m256i;

YORB_AVX2 inline Bytes Load(const uint8_t* from) { return _mm256_loadu_si256(reinterpret_cast<const Bytes*>(from)); }
YORB_AVX2 inline Bytes Min(Bytes a, Bytes b) { return _mm256_min_epu8(a, b); }
YORB_AVX2 inline Bytes Max(Bytes a, Bytes b) { return _mm256_max_epu8(a, b); }
YORB_AVX2 inline Bytes Minus(Bytes a, Bytes b) { return _mm256_subs_epu8(a, b); }

/// An arc of nine or more holds one of any two opposite ring pixels: zero where two such pairs rule out a corner. More
/// pairs cost more than they save.
YORB_AVX2 inline Bytes MayBeCorner(const uint8_t* const ring[kRing], int x, Bytes above, Bytes below) {
  const Bytes top = Load(ring[0] + x), bottom = Load(ring[8] + x);
  const Bytes right = Load(ring[4] + x), left = Load(ring[12] + x);
  const Bytes least = Min(Max(top, bottom), Max(left, right)), most = Max(Min(top, bottom), Min(left, right));
  return _mm256_or_si256(Minus(least, above), Minus(below, most));
}

/// The greatest of all arcs' least pixels, and the least of all arcs' greatest ones. The eight pixels that two
/// neighbouring arcs share are reduced once for both.
template <int kArc>
YORB_AVX2 inline void ExtremesOfArcs(const Bytes (&p)[kRing], Bytes& greatest_least, Bytes& least_greatest) {
  Bytes low[8], high[8], low4[8], high4[8];
  for (int i = 0; i < 8; ++i) {
    low[i] = Min(p[2 * i + 1], p[(2 * i + 2) % kRing]);
    high[i] = Max(p[2 * i + 1], p[(2 * i + 2) % kRing]);
  }
  for (int i = 0; i < 8; ++i) {
    low4[i] = Min(low[i], low[(i + 1) % 8]);
    high4[i] = Max(high[i], high[(i + 1) % 8]);
  }
  greatest_least = _mm256_setzero_si256();
  least_greatest = _mm256_set1_epi8(-1);
  for (int i = 0; i < 8; ++i) {
    Bytes low_shared = Min(low4[i], low4[(i + 2) % 8]), high_shared = Max(high4[i], high4[(i + 2) % 8]);
    for (int j = 9; j < kArc; ++j) {
      low_shared = Min(low_shared, p[(2 * i + j) % kRing]);
      high_shared = Max(high_shared, p[(2 * i + j) % kRing]);
    }
    const Bytes first = p[2 * i], last = p[(2 * i + kArc) % kRing];
    greatest_least = Max(greatest_least, Min(low_shared, Max(first, last)));
    least_greatest = Min(least_greatest, Max(high_shared, Min(first, last)));
  }
}

template <int kArc>
YORB_AVX2 void ScoreRow(const RowTask& task, uint8_t* scores) {
  const uint8_t* ring[kRing];
  for (int i = 0; i < kRing; ++i) ring[i] = task.row + kRingY[i] * task.stride + kRingX[i];
  const Bytes threshold = _mm256_set1_epi8(static_cast<char>(task.threshold));
  const Bytes zero = _mm256_setzero_si256();
  for (int x = task.begin; x < task.end; x += kBlock) {
    const Bytes centre = Load(task.row + x);
    const Bytes above = _mm256_adds_epu8(centre, threshold), below = Minus(centre, threshold);
    Bytes* out = reinterpret_cast<Bytes*>(scores + x);
    const Bytes maybe = MayBeCorner(ring, x, above, below);
    if (_mm256_testz_si256(maybe, maybe)) {
      _mm256_storeu_si256(out, zero);
      continue;
    }
    Bytes p[kRing];
    for (int i = 0; i < kRing; ++i) p[i] = Load(ring[i] + x);
    Bytes greatest_least, least_greatest;
    ExtremesOfArcs<kArc>(p, greatest_least, least_greatest);
    const Bytes contrast = Max(Minus(greatest_least, centre), Minus(centre, least_greatest));
    const Bytes is_low = _mm256_cmpeq_epi8(Minus(contrast, threshold), zero);
    _mm256_storeu_si256(out, _mm256_andnot_si256(is_low, Minus(contrast, _mm256_set1_epi8(1))));
  }
}

/// Eight bytes from each of two rows.
YORB_AVX2 inline __m128i LoadTwo(const uint8_t* upper, const uint8_t* lower) {
  return _mm_unpacklo_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(upper)),
                            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(lower)));
}

/// The least of sixteen bytes.
YORB_AVX2 inline int LeastOf(__m128i bytes) {
  const __m128i pairs = _mm_min_epu8(bytes, _mm_srli_epi16(bytes, 8));
  return _mm_cvtsi128_si32(_mm_minpos_epu16(_mm_and_si128(pairs, _mm_set1_epi16(255)))) & 255;
}

}  // namespace

YORB_AVX2 int TrimmedRingSumAvx2(const uint8_t* centre, ptrdiff_t stride) {
  // Rows above and below the centre share no column with one another, so that all sixteen pixels fit side by side; the
  // two of the middle row take the seventh byte of each half.
  const uint8_t* row = centre - 3;
  const __m128i outer = _mm_set1_epi64x(0x000000ffffff0000), next = _mm_set1_epi64x(0x0000ff000000ff00);
  const __m128i inner = _mm_set1_epi64x(0x00ff0000000000ff);
  const __m128i take_ends = _mm_setr_epi8(-1, -1, -1, -1, -1, -1, -1, 0, -1, -1, -1, -1, -1, -1, -1, 6);
  const __m128i middle = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(row));
  __m128i ring = _mm_shuffle_epi8(middle, take_ends);
  ring = _mm_or_si128(ring, _mm_and_si128(LoadTwo(row - 3 * stride, row + 3 * stride), outer));
  ring = _mm_or_si128(ring, _mm_and_si128(LoadTwo(row - 2 * stride, row + 2 * stride), next));
  ring = _mm_or_si128(ring, _mm_and_si128(LoadTwo(row - stride, row + stride), inner));
  const __m128i halves = _mm_sad_epu8(ring, _mm_setzero_si128());
  const int sum = _mm_cvtsi128_si32(halves) + _mm_extract_epi16(halves, 4);
  const int greatest = 255 - LeastOf(_mm_xor_si128(ring, _mm_set1_epi8(-1)));
  return sum - LeastOf(ring) - greatest;
}

void ScoreRowAvx2(const RowTask& task, uint8_t* scores) {
  switch (task.arc) {
    case 9:
      return ScoreRow<9>(task, scores);
    case 10:
      return ScoreRow<10>(task, scores);
    case 11:
      return ScoreRow<11>(task, scores);
    default:
      return ScoreRow<12>(task, scores);
  }
}

YORB_AVX2 size_t PeaksAvx2(const ThreeRows& scores, int begin, int end, uint32_t* peaks) {
  size_t count = 0;
  for (int x = begin; x < end; x += kBlock) {
    const Bytes here = Load(scores.here + x);
    if (_mm256_testz_si256(here, here)) continue;
    Bytes rival = Max(Load(scores.here + x - 1), Load(scores.here + x + 1));
    for (int i = -1; i <= 1; ++i) rival = Max(rival, Max(Load(scores.above + x + i), Load(scores.below + x + i)));
    const Bytes is_less = _mm256_cmpeq_epi8(Minus(here, rival), _mm256_setzero_si256());
    uint32_t bits = ~static_cast<uint32_t>(_mm256_movemask_epi8(is_less));
    if (end - x < kBlock) bits &= (1u << (end - x)) - 1;
    for (; bits != 0; bits &= bits - 1) peaks[count++] = static_cast<uint32_t>(x + __builtin_ctz(bits));
  }
  return count;
}

}  // namespace yorb::fast

#else

namespace yorb::fast {
void ScoreRowAvx2(const RowTask& task, uint8_t* scores) { ScoreRowPortable(task, scores); }
size_t PeaksAvx2(const ThreeRows& scores, int begin, int end, uint32_t* peaks) {
  return PeaksPortable(scores, begin, end, peaks);
}
int TrimmedRingSumAvx2(const uint8_t* centre, ptrdiff_t stride) { return TrimmedRingSumPortable(centre, stride); }
}  // namespace yorb::fast
#endif
